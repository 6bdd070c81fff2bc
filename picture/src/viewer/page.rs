//! One HTML file: head, program, data. It asks for nothing from outside and forbids itself to.

use super::header::Header;
use super::text;

/// The program and its style, made by `web/build` from `web/src`.
const SCRIPT: &str = include_str!("web/bundle.js");
const STYLE: &str = include_str!("web/bundle.css");
/// What runs the solver, beside the page.
const WORKER: &str = include_str!("web/worker.js");
/// Of three.js and uPlot, which are in the program.
const LICENCES: &str = include_str!("web/licences.txt");

/// Parts of the data by name, deflated.
#[derive(Debug, Default)]
pub(super) struct Parts {
    list: Vec<(String, Vec<u8>)>,
    /// Bytes that they take in the page.
    size: u64,
}

impl Parts {
    pub(super) fn push(&mut self, name: impl Into<String>, bytes: Vec<u8>) {
        let name = name.into();
        self.size += (name.len() + 64) as u64 + text::length(&bytes);
        self.list.push((name, bytes));
    }

    pub(super) fn size(&self) -> u64 {
        self.size
    }

    pub(super) fn extend(&mut self, other: Self) {
        self.size += other.size;
        self.list.extend(other.list);
    }
}

/// Bytes of a page without its data.
pub(super) fn bare(header: &Header) -> u64 {
    let parts = Parts::default();
    html(header, &parts).len() as u64
}

/// The page.
pub(super) fn html(header: &Header, parts: &Parts) -> String {
    // Numbers and texts only: this cannot fail.
    let head = serde_json::to_string(header).unwrap_or_default();
    // Nothing in a text may end the element or begin a comment.
    let head = head.replace('<', "\\u003c");
    let title = escape(&header.title);
    let mut out = String::with_capacity(parts.size as usize + SCRIPT.len() + head.len() + 8192);
    let live = header.live.is_some();
    let solver = if live {
        " 'wasm-unsafe-eval' blob:; worker-src blob:"
    } else {
        ""
    };
    out += &format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'{solver}; \
         style-src 'unsafe-inline'; img-src data: blob:; frame-src 'self' file:\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n"
    );
    if !header.watched.is_empty() {
        // The page looks into a copy of itself whether it is still the newest; that copy stops here.
        out += &format!(
            "<script>if (location.search.startsWith(\"?stamp\")) {{ parent.postMessage(\"{}\", \"*\"); window.stop(); }}</script>\n",
            header.watched
        );
    }
    out += &format!(
        "<style>\n{STYLE}</style>\n</head>\n<body>\n<noscript>This page needs JavaScript.</noscript>\n\
         <script type=\"application/json\" id=\"head\">{head}</script>\n"
    );
    if live {
        out += &format!("<script type=\"text/plain\" id=\"worker\">\n{WORKER}</script>\n");
    }
    for (name, bytes) in &parts.list {
        out += &format!("<script type=\"text/plain\" id=\"{name}\">");
        text::put(&mut out, bytes);
        out += "</script>\n";
    }
    out += &format!(
        "<script type=\"text/plain\" id=\"licences\">\n{LICENCES}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    );
    out
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
