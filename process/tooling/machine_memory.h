// How much memory this process may take.
#pragma once

namespace diefill::process {

/// Bytes: the machine's memory, or less where a limit of the process or of its control group is lower.
double machine_memory();

}  // namespace diefill::process
