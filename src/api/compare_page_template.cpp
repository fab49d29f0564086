#include "api/compare_page_template.hpp"

namespace velarium::compared {

const std::string_view kPageTemplate = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="velarium {{version}}">
<title>{{name}} against {{reference}}</title>
<style>
:root {
  color-scheme: light dark;
  --page: #f5f6f8; --card: #ffffff; --ink: #1b1f27; --faint: #596273; --line: #d9dde5;
  --accent: #2457d6; --good: #17663b; --good-page: #dff3e6; --bad: #9b1c1c; --bad-page: #fbe3e1;
  --check-a: #c9cdd4; --check-b: #e4e6ea;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #12151b; --card: #1b2029; --ink: #e8ebf1; --faint: #9aa4b5; --line: #333b49;
    --accent: #86a9ff; --good: #7fdba6; --good-page: #153524; --bad: #ffa69e; --bad-page: #45201f;
    --check-a: #2a303b; --check-b: #39414f;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem clamp(1rem, 3vw, 3rem) 3rem; max-width: 110rem;
  background: var(--page); color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; }
header { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; align-items: baseline; margin-bottom: 1rem; }
h1 { margin: 0; font-size: 1.35rem; font-weight: 650; overflow-wrap: anywhere; }
h1 span { color: var(--faint); font-weight: 400; }
.verdict { margin: 0; padding: .2rem .8rem; border-radius: 2rem; font-weight: 600; }
.within { background: var(--good-page); color: var(--good); }
.beyond { background: var(--bad-page); color: var(--bad); }
.card { background: var(--card); border: 1px solid var(--line); border-radius: .75rem; overflow: hidden; }
.bar { display: flex; flex-wrap: wrap; gap: .75rem 1.5rem; align-items: center; padding: .75rem 1rem; }
fieldset { display: flex; margin: 0; padding: 0; border: 1px solid var(--line); border-radius: .5rem; }
fieldset label { position: relative; cursor: pointer; }
fieldset label + label { border-left: 1px solid var(--line); }
fieldset span { display: block; padding: .3rem .9rem; }
fieldset input { position: absolute; inset: 0; opacity: 0; margin: 0; cursor: pointer; }
fieldset input:checked + span { background: var(--accent); color: var(--card); }
fieldset label:first-of-type span { border-radius: .45rem 0 0 .45rem; }
fieldset label:last-of-type span { border-radius: 0 .45rem .45rem 0; }
:focus-visible, fieldset input:focus-visible + span { outline: 3px solid var(--accent); outline-offset: 2px; }
select { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: .5rem;
  padding: .3rem .5rem; }
.names { display: flex; justify-content: space-between; gap: 1rem; margin: 0; padding: 0 1rem .5rem; color: var(--faint);
  overflow-wrap: anywhere; }
.stage { overflow: auto; max-height: 76vh; border-block: 1px solid var(--line); text-align: center; touch-action: pan-y; }
.sheet { --split: 50%; position: relative; display: inline-block; vertical-align: top; cursor: col-resize;
  background: repeating-conic-gradient(var(--check-a) 0 25%, var(--check-b) 0 50%) 0 0 / 24px 24px; }
.sheet img { display: block; width: 100%; height: 100%; user-select: none; pointer-events: none; }
.sheet img + img { position: absolute; inset: 0; }
.sheet.large img { image-rendering: pixelated; }
.sheet[data-view="slide"] #reference { clip-path: inset(0 0 0 var(--split)); }
.sheet[data-view="slide"] #picture { clip-path: inset(0 calc(100% - var(--split)) 0 0); }
.sheet[data-view="slide"] #error, .sheet[data-view="picture"] img:not(#picture),
.sheet[data-view="reference"] img:not(#reference), .sheet[data-view="error"] img:not(#error) { visibility: hidden; }
.sheet:not([data-view="slide"]) { cursor: default; }
.divider { position: absolute; inset: 0 auto 0 var(--split); width: 2px; margin-left: -1px; background: #fff;
  box-shadow: 0 0 0 1px #0009; pointer-events: none; }
.sheet:not([data-view="slide"]) .divider { display: none; }
.controls { display: flex; flex-wrap: wrap; gap: .5rem 2rem; align-items: center; padding: .75rem 1rem; }
.controls label { flex: 1 1 20rem; display: flex; gap: .75rem; align-items: center; }
.controls input { flex: 1; accent-color: var(--accent); }
.legend { flex: 1 1 16rem; display: flex; gap: .6rem; align-items: center; color: var(--faint); }
.legend i { flex: 1; height: .8rem; border-radius: .4rem; background: linear-gradient(to right, {{gradient}}); }
.below { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); margin-top: 1rem;
  align-items: start; }
.below section { padding: 1rem; }
h2 { margin: 0 0 .5rem; font-size: 1.05rem; }
table { width: 100%; border-collapse: collapse; }
th, td { padding: .35rem .5rem; border-top: 1px solid var(--line); text-align: left; vertical-align: baseline; }
tr:first-child > * { border-top: 0; }
th { font-weight: 500; white-space: nowrap; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.help { color: var(--faint); }
tr.decides th, tr.decides td.number { font-weight: 700; }
ul { margin: 0; padding-left: 1.2rem; }
kbd { padding: .05rem .4rem; border: 1px solid var(--line); border-radius: .3rem; font: inherit; font-size: .9em; }
.keys { color: var(--faint); }
</style>
</head>
<body>
<header>
<h1>{{name}} <span>against</span> {{reference}}</h1>
<p class="verdict {{class}}">{{verdict}}</p>
</header>
<main>
<section class="card" aria-label="The pictures">
<div class="bar">
<fieldset aria-label="View">
<label><input type="radio" name="view" value="slide" checked><span>Slide</span></label>
<label><input type="radio" name="view" value="picture"><span>Picture</span></label>
<label><input type="radio" name="view" value="reference"><span>Reference</span></label>
<label><input type="radio" name="view" value="error"><span>Error</span></label>
</fieldset>
<label>Zoom <select id="zoom">
<option value="fit" selected>fit</option><option value="1">1&times;</option><option value="2">2&times;</option>
<option value="4">4&times;</option><option value="8">8&times;</option><option value="16">16&times;</option>
</select></label>
</div>
<p class="names"><span>Picture: {{name}}</span><span>Reference: {{reference}}</span></p>
<div class="stage" id="stage" tabindex="0" role="group" aria-label="Pictures, one over the other">
<div class="sheet" id="sheet" data-view="slide">
<img id="reference" alt="The reference, {{reference}}" src="{{reference_png}}">
<img id="picture" alt="The picture, {{name}}" src="{{picture_png}}">
<img id="error" alt="Map of perceived differences" src="{{error_png}}">
<div class="divider"></div>
</div>
</div>
<div class="controls">
<label>Divider <input type="range" id="split" min="0" max="100" step="0.5" value="50"></label>
<div class="legend"><span>error 0</span><i></i><span>1</span></div>
</div>
</section>
<div class="below">
<section class="card" aria-labelledby="numbers">
<h2 id="numbers">Numbers</h2>
<table>
{{rows}}
</table>
</section>
<section class="card" aria-labelledby="remarks">
<h2 id="remarks">Remarks</h2>
<ul>
{{remarks}}
</ul>
<p class="keys"><kbd>1</kbd> to <kbd>4</kbd> choose the view, <kbd>Space</kbd> exchanges picture and reference,
<kbd>&larr;</kbd> <kbd>&rarr;</kbd> move the divider, <kbd>+</kbd> <kbd>-</kbd> zoom.</p>
</section>
</div>
</main>
<script>
"use strict";
const stage = document.getElementById("stage"), sheet = document.getElementById("sheet");
const split = document.getElementById("split"), zoom = document.getElementById("zoom");
const views = [...document.querySelectorAll("input[name=view]")];
const width = {{width}}, height = {{height}};

function showView(name) {
  const chosen = views.find(view => view.value === name);
  if (!chosen) return;
  chosen.checked = true;
  sheet.dataset.view = name;
  split.disabled = name !== "slide";
}
// page.html#view=error
function showLinked() { showView(new URLSearchParams(location.hash.slice(1)).get("view")); }
function showSplit() { sheet.style.setProperty("--split", split.value + "%"); }
function showZoom() {
  const room = Math.min(stage.clientWidth, 0.74 * innerHeight * width / height);
  const wanted = zoom.value === "fit" ? room : zoom.value * width / devicePixelRatio;
  sheet.style.width = wanted + "px";
  sheet.style.height = wanted * height / width + "px";
  sheet.classList.toggle("large", wanted * devicePixelRatio >= 2 * width);
}
function stepZoom(by) {
  const next = zoom.selectedIndex + by;
  if (next >= 0 && next < zoom.options.length) zoom.selectedIndex = next;
  showZoom();
}
function moveSplit(by) { split.value = Number(split.value) + by; showSplit(); }
function drag(event) {
  if (sheet.dataset.view !== "slide" || !(event.buttons & 1)) return;
  const box = sheet.getBoundingClientRect();
  split.value = 100 * (event.clientX - box.left) / box.width;
  showSplit();
}
function press(event) {
  if (event.altKey || event.ctrlKey || event.metaKey || event.target === zoom || event.target === split) return;
  const onView = views.includes(event.target);
  const number = Number(event.key);
  if (number >= 1 && number <= views.length) showView(views[number - 1].value);
  else if (event.key === " ") showView(sheet.dataset.view === "picture" ? "reference" : "picture");
  else if (event.key === "+" || event.key === "=") stepZoom(1);
  else if (event.key === "-") stepZoom(-1);
  else if (event.key === "ArrowLeft" && !onView) moveSplit(-1);
  else if (event.key === "ArrowRight" && !onView) moveSplit(1);
  else return;
  event.preventDefault();
}
views.forEach(view => view.addEventListener("change", () => showView(view.value)));
split.addEventListener("input", showSplit);
zoom.addEventListener("change", showZoom);
sheet.addEventListener("pointerdown", drag);
sheet.addEventListener("pointermove", drag);
addEventListener("keydown", press);
addEventListener("resize", showZoom);
addEventListener("hashchange", showLinked);
showLinked();
showSplit();
showZoom();
</script>
</body>
</html>
)html";

}  // namespace velarium::compared
