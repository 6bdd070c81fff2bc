// A page of `view --watch` renews itself when its file is written anew.

const PAUSE = 700;
const MARK = "#kept=";

/** Looks at the file from time to time; `keep()` tells what a renewed page begins with. Answers with what was kept. */
export function watch(stamp, keep) {
  let kept = {};
  if (location.hash.startsWith(MARK)) {
    kept = JSON.parse(decodeURIComponent(location.hash.slice(MARK.length)));
  }
  if (!stamp) return kept;
  const file = location.href.replace(/[?#].*$/, "");
  addEventListener("message", ({ data, source }) => {
    if (source !== look?.contentWindow || typeof data !== "string" || data === stamp) return;
    location.replace(`${file}?${data}${MARK}${encodeURIComponent(JSON.stringify(keep()))}`);
  });
  // A file may not be read by a page beside it, but it may be shown in it: its first line says what it is and stops.
  let look = null;
  setInterval(() => {
    look?.remove();
    look = Object.assign(document.createElement("iframe"), { hidden: true, src: `${file}?stamp=${Date.now()}` });
    document.body.append(look);
  }, PAUSE);
  return kept;
}
