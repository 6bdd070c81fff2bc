"""Headless Chromium for pages of `sphere-dda view`, without a network."""

import json
import shutil
from contextlib import contextmanager

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
DRIVER = shutil.which("chromedriver")
needed = pytest.mark.skipif(
    not (CHROMIUM and DRIVER), reason="no `chromium` and `chromedriver`: pages of `view` NOT TESTED; install them (Debian: chromium, chromium-driver)"
)
# No name is resolved; nothing is fetched in the background; software rendering, the same on every machine.
FLAGS = (
    "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND", "--use-gl=angle",
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--force-device-scale-factor=1",
    "--enable-precise-memory-info",
)


class Browser:
    """A window of 1280 x 800 and what its pages logged and asked the network for."""

    def __init__(self, driver):
        self.driver = driver

    def open(self, page):
        """Opens a page and waits for its first picture."""
        from selenium.webdriver.support.ui import WebDriverWait

        self.log(), self.requests()
        self.driver.get(page.resolve().as_uri())
        # `get` may come back before the script of a large page has begun.
        WebDriverWait(self.driver, 30, 0.05).until(lambda _: self.at_once("typeof sphereDda") == "object")
        return self.run("await sphereDda.ready; return sphereDda.head")

    def run(self, code):
        """The value that code returns, or its exception."""
        wrapped = (
            "const done = arguments[arguments.length - 1];"
            f"(async () => {{ {code} }})().then((value) => done({{value}}), (error) => done({{error: String(error.stack ?? error)}}));"
        )
        out = self.driver.execute_async_script(wrapped)
        assert "error" not in out, out["error"]
        return out.get("value")

    def at_once(self, expression):
        """The value of an expression now. Unlike `run` it waits for nothing, so a page that reloads cannot leave it waiting."""
        return self.driver.execute_script(f"return {expression}")

    def log(self):
        """Warnings and errors of the console since the last look."""
        return [f"{entry['level']}: {entry['message']}" for entry in self.driver.get_log("browser")]

    def requests(self):
        """Addresses that were asked for since the last look."""
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        return [e["params"]["request"]["url"] for e in events if e["method"] == "Network.requestWillBeSent"]


@contextmanager
def started(folder):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for flag in (*FLAGS, f"--user-data-dir={folder}", "--window-size=1280,800"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "WARNING", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    driver.set_script_timeout(120)
    # The size of the page itself.
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 1280, "height": 800, "deviceScaleFactor": 1, "mobile": False})
    try:
        yield Browser(driver)
    finally:
        driver.quit()
