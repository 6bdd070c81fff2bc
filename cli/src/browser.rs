//! A browser without a window, driven through the Chrome DevTools Protocol: it draws the pages of `view` into films.
//!
//! Source: <https://chromedevtools.github.io/devtools-protocol/>.

use std::env;
use std::io::{BufRead as _, BufReader};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use miette::miette;
use serde_json::{Value, json};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

use crate::failure::Failure;

/// Names under which the browser is installed.
const NAMES: [&str; 5] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "msedge",
];
/// Names another browser.
const VARIABLE: &str = "SPHERE_DDA_BROWSER";
/// No name is resolved, nothing is fetched in the background, and software draws: the same picture on every machine. The
/// sandbox, which refuses to start for root and in containers, would guard against a page from elsewhere: this one is ours.
const FLAGS: [&str; 14] = [
    "--headless=new",
    "--remote-debugging-port=0",
    "--no-sandbox",
    "--no-first-run",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--hide-scrollbars",
];
/// Longest time until the browser answers, and until a page has its first picture.
const PATIENCE: Duration = Duration::from_secs(60);

/// The first of `names` on the PATH.
pub(crate) fn on_path(names: &[&str]) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    let places: Vec<PathBuf> = env::split_paths(&path).collect();
    let files = names.iter().flat_map(|name| {
        let own = move |place: &PathBuf| place.join(format!("{name}{}", env::consts::EXE_SUFFIX));
        places.iter().map(own)
    });
    files.into_iter().find(|file| file.is_file())
}

/// A running browser with one page.
pub(crate) struct Browser {
    process: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: String,
    asked: u64,
    _profile: TempDir,
}

fn failed(what: impl std::fmt::Display) -> Failure {
    Failure::Run(miette!("the browser that draws the film: {what}"))
}

impl Browser {
    /// Starts a browser.
    ///
    /// # Errors
    /// None is installed, or it does not answer.
    pub(crate) fn start() -> Result<Self, Failure> {
        let named = env::var_os(VARIABLE).map(PathBuf::from);
        let program = named.or_else(|| on_path(&NAMES)).ok_or_else(|| {
            Failure::Input(miette!(
                "found no Chromium to draw the film, expected one of {} on the PATH, or its path in {VARIABLE}; \
                 on Debian: apt-get install chromium. `sphere-dda view` needs none: its page opens in any browser",
                NAMES.join(", ")
            ))
        })?;
        let profile = tempfile::tempdir().map_err(Failure::run)?;
        let mut process = Command::new(&program)
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .arg("about:blank")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| {
                failed(format_args!(
                    "cannot start `{}`: {error}",
                    program.display()
                ))
            })?;
        let Some(address) = address(&mut process) else {
            // It has ended or never will do more.
            let _ = process.kill();
            let _ = process.wait();
            return Err(failed(format_args!(
                "`{}` does not answer",
                program.display()
            )));
        };
        let (socket, _) = tungstenite::connect(&address).map_err(failed)?;
        let mut browser = Self {
            process,
            socket,
            session: String::new(),
            asked: 0,
            _profile: profile,
        };
        let target = browser.ask("Target.createTarget", json!({ "url": "about:blank" }))?;
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let session = browser.ask("Target.attachToTarget", attach)?;
        browser.session = session["sessionId"].as_str().unwrap_or_default().to_owned();
        Ok(browser)
    }

    /// Opens a page of `view` and waits until it has drawn its first picture.
    ///
    /// # Errors
    /// A page that cannot be shown, with the reason it gives.
    pub(crate) fn open(&mut self, page: &Path) -> Result<(), Failure> {
        let address = url::Url::from_file_path(page);
        let address =
            address.map_err(|()| failed(format_args!("no address for `{}`", page.display())))?;
        self.ask("Page.navigate", json!({ "url": address.as_str() }))?;
        let began = Instant::now();
        loop {
            // While one page gives way to the next there is nobody to ask.
            let there = self.run("typeof sphereDda");
            if there.is_ok_and(|kind| kind == "object") {
                return self.run("sphereDda.ready").map(|_| ());
            }
            if began.elapsed() > PATIENCE {
                return Err(failed("the page does not begin"));
            }
            sleep(Duration::from_millis(20));
        }
    }

    /// The value of an expression in the page, awaited if it is a promise.
    ///
    /// # Errors
    /// The exception that it throws.
    pub(crate) fn run(&mut self, expression: &str) -> Result<Value, Failure> {
        let what = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let mut answer = self.ask("Runtime.evaluate", what)?;
        if let Some(thrown) = answer.get("exceptionDetails") {
            let text = thrown["exception"]["description"].as_str();
            let first = text.and_then(|text| text.lines().next());
            return Err(failed(first.unwrap_or("the page refuses")));
        }
        Ok(answer["result"]["value"].take())
    }

    fn ask(&mut self, method: &str, parameters: Value) -> Result<Value, Failure> {
        self.asked += 1;
        let mut message = json!({ "id": self.asked, "method": method, "params": parameters });
        if !self.session.is_empty() {
            message["sessionId"] = json!(self.session);
        }
        let text = Message::text(message.to_string());
        self.socket.send(text).map_err(failed)?;
        loop {
            let Message::Text(text) = self.socket.read().map_err(failed)? else {
                continue;
            };
            let mut answer: Value = serde_json::from_str(&text).map_err(failed)?;
            if answer["id"] != self.asked {
                continue;
            }
            if let Some(why) = answer["error"]["message"].as_str() {
                return Err(failed(format_args!("{method}: {why}")));
            }
            return Ok(answer["result"].take());
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // It may have gone already.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Where the browser can be talked to, from what it says as it starts.
fn address(process: &mut Child) -> Option<String> {
    let mut lines = BufReader::new(process.stderr.take()?).lines();
    let found = lines.by_ref().map_while(Result::ok).find_map(|line| {
        let (_, address) = line.split_once("DevTools listening on ")?;
        Some(address.trim().to_owned())
    });
    // What it says later must find a reader.
    std::thread::spawn(move || lines.map_while(Result::ok).for_each(drop));
    found
}
