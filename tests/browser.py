"""Chromium for tests, so that it starts anywhere: as root, in a container or chroot without user namespaces and /dev/shm, without a
home, behind a proxy, on a busy machine."""
import os
import shutil
import tempfile

PATIENCE = 600  # seconds: only what hangs takes them


def missing():
    """What is not there, as a sentence; empty if a page can be opened."""
    for program, package in (("chromium", "chromium"), ("chromedriver", "chromium-driver")):
        if not shutil.which(program):
            return f"{program} is not installed (Debian's package {package})"
    try:
        import selenium  # noqa: F401
    except ImportError:
        return "python3-selenium is not installed"
    return ""


def start(*logs):
    """A driver that keeps the named logs of Chromium ("browser", "performance")."""
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.remote.remote_connection import RemoteConnection
    options = Options()
    options.binary_location = shutil.which("chromium")
    # All pages are ours, and Chromium's sandbox wants user namespaces or a program with root's rights.
    for argument in ("--headless=new", "--hide-scrollbars", "--disable-gpu", "--no-sandbox", "--disable-dev-shm-usage"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {log: "ALL" for log in logs})
    os.environ["NO_PROXY"] = os.environ["no_proxy"] = "localhost,127.0.0.1"  # where the driver listens
    RemoteConnection.set_timeout(PATIENCE)
    home = tempfile.TemporaryDirectory(prefix="raytree-browser-", ignore_cleanup_errors=True)
    service = Service(shutil.which("chromedriver"), env={**os.environ, "HOME": home.name})
    driver = webdriver.Chrome(service=service, options=options)
    driver.set_page_load_timeout(PATIENCE)
    driver.set_script_timeout(PATIENCE)
    end = driver.quit

    def quit_and_tidy():
        end()
        home.cleanup()

    driver.quit = quit_and_tidy
    return driver
