"""The page in a browser without a window, and the runner of its tests: page_test.py, live_test.py."""
import base64
import pathlib
import time
import traceback

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

root = pathlib.Path(__file__).resolve().parents[2]
longest_wait = 30  # seconds


class page:
    """The page in a browser."""

    def __init__(self, file, pictures):
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--force-color-profile=srgb"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_script_timeout(300)
        self.url = file.resolve().as_uri()
        self.pictures = pictures
        self.size(1000, 900)

    def size(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})

    def scheme(self, name):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": name}]})

    def open(self, state=""):
        self.driver.get("about:blank")  # a new fragment alone would not load the page again
        self.driver.get(self.url + "#" + state)
        self.until(lambda: self.run("return document.documentElement.dataset.ready") is not None)
        assert self.run("return document.documentElement.dataset.ready") == "true", self.text("#status")

    def run(self, script, *values):
        return self.driver.execute_script(script, *values)

    def until(self, condition, what="the page does not get there"):
        WebDriverWait(self.driver, longest_wait, 0.05).until(lambda _: condition(), what)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0])?.innerText ?? ''", selector)

    def paste(self, text):
        """As from the clipboard: the whole text at once."""
        self.run("const box = document.querySelector('#text'); box.value = arguments[0];"
                 "box.dispatchEvent(new Event('input', {bubbles: true}));", text)

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def picture(self, name):
        height = self.run("return document.documentElement.scrollHeight")
        width = self.run("return innerWidth")
        shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {
            "captureBeyondViewport": True, "clip": {"x": 0, "y": 0, "width": width, "height": min(height, 4000), "scale": 1}})
        self.pictures.mkdir(parents=True, exist_ok=True)
        (self.pictures / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))


tests = []


def test(function):
    tests.append(function)
    return function


def contrast(p, selector):
    """Of text with what is behind it: WCAG 2."""
    return p.run("""
        const luminance = colour => {
            const [r, g, b] = colour.match(/[\\d.]+/g).map(Number).map(c => (c /= 255) <= .03928 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4);
            return .2126 * r + .7152 * g + .0722 * b;
        };
        const element = document.querySelector(arguments[0]);
        let behind = element;
        while (behind && /, 0\\)$/.test(getComputedStyle(behind).backgroundColor)) behind = behind.parentElement;
        const a = luminance(getComputedStyle(element).color), b = luminance(getComputedStyle(behind ?? document.documentElement).backgroundColor);
        return (Math.max(a, b) + .05) / (Math.min(a, b) + .05);""", selector)


def unnamed_controls(p):
    """How many controls the page has, and those without a name for screen readers."""
    roles = {"button", "textbox", "combobox", "checkbox", "searchbox", "tab", "tree", "treeitem", "link", "listbox", "tabpanel", "log", "image"}
    nodes = p.driver.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
    found = [node for node in nodes if not node.get("ignored") and node.get("role", {}).get("value") in roles]
    return len(found), [(node["role"]["value"], node.get("properties")) for node in found if not node.get("name", {}).get("value", "").strip()]


def run_tests(p, names):
    """Runs the tests with one of these in their names, or all. The exit code."""
    failed = 0
    try:
        for one in tests:
            name = one.__name__.replace("_", " ")
            if names and not any(part in name for part in names):
                continue
            start = time.monotonic()
            try:
                one(p)
                print(f"passed  {time.monotonic() - start:5.1f} s  {name}", flush=True)
            except Exception:
                failed += 1
                print(f"FAILED  {time.monotonic() - start:5.1f} s  {name}\n{traceback.format_exc()[-3000:]}", flush=True)
                p.picture("failed-" + one.__name__)
    finally:
        p.driver.quit()
    print(f"{len(tests)} tests, {failed} failed" if not names else f"{failed} failed")
    return 1 if failed else 0
