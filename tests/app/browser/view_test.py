"""Drives the interactive view of a report in Chromium: every control, mouse, touch and keys.

    python3 view_test.py CHROMIUM PAGE.html [FOLDER for pictures]

Says what fails on standard error and ends with 1.
"""
import sys

from page import Page

VIEW = "document.querySelector('.view3d').view"
# The picture as one number, drawn here and now.
LOOK = """(() => {
  const view = %s, gl = view.renderer.getContext();
  view.draw(0.5);
  const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  let sum = 7, dark = 0;
  for (let k = 0; k < bytes.length; ++k) { sum = (31 * sum + bytes[k]) | 0; if (bytes[k] < 200) ++dark; }
  return [sum, dark];
})()""" % VIEW
FAILED = []


def expect(truth, words):
    if not truth:
        FAILED.append(words)


def set_control(page, name, value):
    """A control as the user sets it: `value` for choices and sliders, None for what is clicked."""
    page.run("""((name, value) => {
      const control = document.querySelector('[data-control="' + name + '"]');
      if (value === null) { control.click(); return; }
      control.value = value;
      control.dispatchEvent(new Event(control.tagName === "SELECT" ? "change" : "input", { bubbles: true }));
    })(%r, %s)""" % (name, "null" if value is None else repr(value)))


def expect_change(page, words, act):
    before = page.run(LOOK)
    act()
    expect(page.run(LOOK) != before, words + " changes nothing")


def open_view(page, file):
    page.open(file)
    page.wait("document.querySelector('.view3d') && (document.querySelector('.view3d').dataset.problem || "
              "(document.querySelector('.viewer') && document.querySelector('.viewer').dataset.drawn > 0))")
    problem = page.run("document.querySelector('.view3d').dataset.problem || ''")
    expect(problem == "", "the view does not start: " + problem)
    expect(page.run("getComputedStyle(document.querySelector('.still')).display") == "none", "the still picture stays")
    expect(page.run(LOOK)[1] > 5000, "the picture is empty")


def try_controls(page):
    for name in page.run("[...document.querySelectorAll('[data-control^=camera-]')].map((one) => one.dataset.control)"):
        if name != "camera-front":
            expect_change(page, name, lambda: set_control(page, name, None))
    set_control(page, "camera-cavity", None)
    set_control(page, "camera-corner", None)
    for name in page.run("[...document.querySelectorAll('[data-control^=tool-]')].map((one) => one.dataset.control)"):
        expect_change(page, name, lambda: set_control(page, name, None))
        set_control(page, name, None)
    expect_change(page, "opacity", lambda: set_control(page, "opacity", "80"))
    for colour in page.run("[...document.querySelector('[data-control=colour]').options].map((one) => one.value)")[1:]:
        expect_change(page, "colour " + colour, lambda: set_control(page, "colour", colour))
    set_control(page, "colour", "fraction")
    expect_change(page, "inside", lambda: set_control(page, "inside", None))
    expect_change(page, "first instant", lambda: set_control(page, "time", "0"))
    set_control(page, "time", page.run("document.querySelector('[data-control=time]').max"))
    expect_change(page, "section", lambda: set_control(page, "section", "1"))
    for name in ("cut-powder", "cut-tools", "density", "bands", "flip"):
        expect_change(page, name, lambda: set_control(page, name, None))
        set_control(page, name, None)
    expect_change(page, "place", lambda: page.run("(() => { const slider = document.querySelector('[data-control=place]');"
                  "slider.value = Number(slider.value) + 0.2 * (slider.max - slider.min);"
                  "slider.dispatchEvent(new Event('input')); })()"))
    set_control(page, "section", "")
    expect_change(page, "zones", lambda: set_control(page, "powder", "zones"))
    expect_change(page, "loose", lambda: page.run("(() => { const slider = document.querySelector('[data-control=loose]');"
                  "slider.value = slider.max; slider.dispatchEvent(new Event('input')); })()"))
    expect(page.run("/looser: (9|100)/.test(document.querySelector('.shares').textContent)"),
           "the share of the zone is not told")
    set_control(page, "powder", "nothing")
    set_control(page, "powder", "grains")


def try_hands(page):
    page.run("document.querySelector('.viewer canvas').scrollIntoView({ block: 'center' })")
    box = page.run("(() => { const box = document.querySelector('.viewer canvas').getBoundingClientRect();"
                   "return [box.left, box.top, box.width, box.height]; })()")
    x, y = box[0] + 0.5 * box[2], box[1] + 0.5 * box[3]
    expect_change(page, "dragging", lambda: page.drag(x, y, 60, 20))
    expect_change(page, "the wheel", lambda: page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-240))
    expect_change(page, "dragging with the right button", lambda: page.drag(x, y, 40, 40, "right", 2))
    page.run("document.querySelector('.viewer canvas').focus()")
    for key in ("ArrowLeft", "ArrowUp", "+", "-", "Home", "2", "5", "3"):
        expect_change(page, "key " + key, lambda: page.key(key))
    before = page.run(VIEW + ".state.instant")
    page.key(",")
    expect(page.run(VIEW + ".state.instant") != before, "key , does not step")
    page.key(".")
    page.run(VIEW + ".frameCavity()")
    middle = page.run("(() => { const cell = %s.cells[0]; return [cell.x + 0.5 * cell.width,"
                      "cell.y + 0.5 * cell.height]; })()" % VIEW)
    x, y = box[0] + middle[0], box[1] + middle[1]  # of the first run
    page.mouse("mouseMoved", x, y)
    page.run(VIEW + ".pointer.show({ clientX: %f, clientY: %f })" % (x, y))
    tip = page.run("document.querySelector('.tip').textContent")
    expect("solid fraction" in tip and "mm" in tip, "no value under the pointer: " + tip)
    page.key(" ")
    expect(page.run(VIEW + ".playing"), "space does not play")
    page.key(" ")


def try_touch(page):
    page.size(400, 800, touch=True)
    page.wait("document.querySelector('.viewer canvas').clientWidth < 400")
    try:  # the rest of the page follows the window's size when the browser comes to it
        page.wait("document.documentElement.scrollWidth <= 400", patience=30)
    except TimeoutError:
        expect(False, "the page is wider than a narrow window")
    page.run("document.querySelector('.viewer').scrollIntoView()")

    def turn():
        page.touch("touchStart", (150, 150))
        page.touch("touchMove", (210, 170))
        page.touch("touchEnd")

    def pinch():
        page.touch("touchStart", (120, 150), (220, 150))
        page.touch("touchMove", (100, 150), (240, 150))
        page.touch("touchEnd")

    expect_change(page, "one finger", turn)
    expect_change(page, "two fingers", pinch)


def try_without_webgl(chromium, file):
    with Page(chromium, flags=("--disable-gpu", "--disable-3d-apis")) as page:
        page.open(file)
        page.wait("document.querySelector('.view3d') && document.querySelector('.view3d').dataset.problem")
        expect(page.run("document.querySelector('.still img').naturalWidth") > 100, "no still picture without WebGL")
        expect(page.run("getComputedStyle(document.querySelector('.still')).display") != "none",
               "the still picture is hidden without WebGL")


def main(chromium, file, folder=None):
    with Page(chromium) as page:
        open_view(page, file)
        if folder:
            page.run("document.querySelector('.viewer').scrollIntoView()")
            page.run("new Promise((done) => setTimeout(done, 1500))")
            page.picture(folder + "/view_1280.png")
        page.size(760, 640)
        page.wait("document.querySelector('.viewer').clientWidth < 760")
        try_controls(page)
        try_hands(page)
        try_touch(page)
        if folder:
            page.run("new Promise((done) => setTimeout(done, 1500))")
            page.picture(folder + "/view_400.png")
        expect(page.console == [], "the console says: " + str(page.console))
        others = [url for url in page.requests if not url.startswith(("file://", "data:", "blob:"))]
        expect(others == [] and sum(url.startswith("file://") for url in page.requests) == 1, "requests: " + str(others))
    try_without_webgl(chromium, file)
    for words in FAILED:
        print(words, file=sys.stderr)
    return 1 if FAILED else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
