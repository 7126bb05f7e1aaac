// diefill: predicts how powder fills a die.
#include "app/program.h"

int main(int argc, char** argv) {
  return diefill::app::run_program(argc, argv);
}
