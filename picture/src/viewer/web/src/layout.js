// The elements of the page.

export const LAYOUT = `
<main id="picture">
  <canvas id="canvas"></canvas><canvas id="overlay"></canvas>
  <pre id="notice" hidden></pre><div id="told" hidden></div>
</main>
<aside>
  <section id="live" hidden><h1>Inputs</h1></section>
  <h1>Spheres</h1>
  <label>colour <select id="colour"></select></label>
  <div class="row" id="range"><input type="number" id="low" step="any" title="colour of the lowest value">
    <input type="number" id="high" step="any" title="colour of the highest value"><button id="auto">auto</button></div>
  <label class="check"><input type="checkbox" id="spheres" checked>spheres</label>
  <label class="check"><input type="checkbox" id="forces">contact forces</label>
  <label>line width <input type="range" id="width" min="-1" max="1" step="0.05" value="0"></label>
  <h1>Boundaries</h1>
  <label id="felt">colour <select id="wall"><option value="">none</option></select></label>
  <label>opacity <input type="range" id="opacity" min="0" max="1" step="0.05" value="0.25"></label>
  <label class="check"><input type="checkbox" id="names">names</label>
  <h1>View</h1>
  <div class="row" id="presets"></div>
  <label>cut <select id="cut"><option value="">none</option><option value="x">shows large x</option><option value="y">shows large y</option>
    <option value="z">shows large z</option><option value="-x">shows small x</option><option value="-y">shows small y</option><option value="-z">shows small z</option></select></label>
  <label>place of cut <input type="range" id="place" min="0" max="1" step="0.005" value="0.5"></label>
  <div class="row"><button id="save">picture</button></div>
  <section id="history"><h1>History</h1>
    <input type="text" id="column" list="columns" placeholder="add a column ..."><datalist id="columns"></datalist>
    <div id="plots"></div></section>
</aside>
<footer>
  <button id="play" title="space">play</button>
  <button id="back" title="arrow left: frame before">‹</button><button id="on" title="arrow right: next frame">›</button>
  <button id="reset" hidden>reset</button>
  <input type="range" id="slider" min="0" step="any">
  <span id="pace"></span><span id="time"></span>
  <label title="simulated seconds in a second">speed <select id="speed"></select></label>
</footer>`;
