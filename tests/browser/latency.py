"""How long a reader waits after pressing a key: ``python tests/browser/latency.py`` prints medians, fails over a bar.

A control point is moved with real presses of an arrow key. The page's own clock measures from the time that the
browser stamps on the key's event, before any code of ours sees it:

- picture: until the moved picture is in the page and laid out, so that the next frame shows it;
- frame: until that frame has been painted; most of it is waiting for the screen, which shows 60 a second;
- readout (JupyterLab only): until Python's exact numbers for the new position are in the page and no longer stale.
"""

import sys
import tempfile
from pathlib import Path
from statistics import median

from browser_chromium import launched
from browser_screen import Screen
from browser_servers import A_BOARD, jupyterlab, write_notebook

from bezteach import cli

PRESSES, WARMING = 40, 5
BARS = {"picture": 5, "readout": 60}  # milliseconds

WATCH = """root => {
  const svg = root.querySelector(".bt-picture > svg"), readout = root.querySelector(".bt-readout");
  let began, waited;
  const since = name => { if (!(name in waited)) waited[name] = performance.now() - began; };
  addEventListener("keydown", event => { began = event.timeStamp; waited = globalThis.waited = {}; }, true);
  new MutationObserver(() => {
    if (!waited) return;
    svg.getBoundingClientRect(); // the layout, which would else come with the frame
    if (!("picture" in waited)) {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => since("frame");
      requestAnimationFrame(() => port2.postMessage(null)); // which arrives when the frame is painted
    }
    since("picture");
    if (!readout.classList.contains("bt-stale")) since("readout");
  }).observe(root, { subtree: true, childList: true, attributes: true });
}"""


def measured(page):
    """Milliseconds by name, one for each press of a key."""
    screen = Screen(page)
    screen.root.evaluate(WATCH)
    screen.handle(1).focus()
    presses = []
    for i in range(WARMING + PRESSES):
        page.evaluate("globalThis.waited = null")
        page.keyboard.press(("ArrowLeft", "ArrowRight")[i % 2])
        page.wait_for_function("waited && 'frame' in waited && 'readout' in waited")
        presses.append(page.evaluate("waited"))
    return {name: [press[name] for press in presses[WARMING:]] for name in presses[0]}


def on_the_exported_page(browser, folder):
    """Measured where there is no Python."""
    assert cli.main(["export", str(folder / "board.html")]) == 0
    page = browser.new_page()
    page.goto((folder / "board.html").as_uri())
    waited = measured(page)
    return {name: waited[name] for name in ("picture", "frame")}


def in_jupyterlab(browser, folder):
    """Measured with a kernel behind the board."""
    work, home = folder / "work", folder / "home"
    work.mkdir(), home.mkdir()
    write_notebook(work / "board.ipynb", *A_BOARD)
    with jupyterlab(work, home) as server:
        page = browser.new_page(viewport={"width": 1200, "height": 900})
        server.run_all(page, "board.ipynb")
        waited = measured(page)
        page.close()
        return waited


def main():
    """Print the medians; 1 if one is over its bar."""
    with tempfile.TemporaryDirectory() as folder, launched() as browser:
        places = {place.__name__: place(browser, Path(folder)) for place in (on_the_exported_page, in_jupyterlab)}
    over = False
    for place, waited in places.items():
        for name, times in waited.items():
            bar = BARS.get(name)
            over |= bar is not None and median(times) > bar
            said = f" (bar {bar})" if bar else ""
            print(f"{place.replace('_', ' ')}: {name} {median(times):.1f} ms{said}, slowest {max(times):.0f}")
    return int(over)


if __name__ == "__main__":
    sys.exit(main())
