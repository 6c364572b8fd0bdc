// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_parts.hpp"

namespace granum::plot {

const char* page_style() {
  return R"(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c1f23; --soft: #565d66; --rule: #d5d9de;
  --panel: #f5f6f8; --link: #0b5394; --yes: #00664a; --no: #a83200; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #15181c; --ink: #e9ebee; --soft: #a9b1ba; --rule: #3a4048; --panel: #1d2126;
    --link: #8cc8f0; --yes: #3fc79a; --no: #f59a63; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 0 1.2rem 3rem; background: var(--paper); color: var(--ink);
  font: 17px/1.5 system-ui, Helvetica, Arial, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 1.2rem 0 0.6rem; }
h2 { font-size: 1.35rem; margin: 2.2rem 0 0.4rem; padding-top: 1.2rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1.05rem; margin: 0.8rem 0 0.2rem; }
a { color: var(--link); }
p { margin: 0.5rem 0; max-width: 46rem; }
.first { display: grid; gap: 0 2.2rem; grid-template-columns: minmax(0, 5fr) minmax(0, 6fr);
  align-items: start; }
.first h1 { grid-column: 1 / -1; }
.answer p { font-size: 1.08rem; margin: 0 0 0.8rem; }
.soft, figcaption { color: var(--soft); font-size: 0.93rem; }
figure { margin: 0.6rem 0 1.2rem; }
figcaption { margin: 0.3rem 0; max-width: 46rem; }
.panels { display: grid; gap: 0.8rem 1.4rem;
  grid-template-columns: repeat(auto-fit, minmax(min(21rem, 100%), 1fr)); }
.panel svg { display: block; width: 100%; height: auto; max-width: 46rem; }
.trio { display: grid; gap: 0 1.6rem;
  grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); }
.unchosen { display: none; }
.switch button { font: inherit; font-size: 0.93rem; margin: 0 0.4rem 0.4rem 0; padding: 0.2rem 0.8rem;
  cursor: pointer; color: var(--ink);
  background: var(--panel); border: 1px solid var(--soft); border-radius: 5px; }
.switch button[aria-pressed="true"] { color: var(--paper); background: var(--ink); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.92rem; margin: 0.5rem 0 1rem; }
th, td { padding: 0.2rem 1rem 0.2rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--rule); }
th { color: var(--soft); font-weight: 600; }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.yes { color: var(--yes); }
.no { color: var(--no); font-weight: 600; }
li { margin: 0.2rem 0; max-width: 46rem; }
details { border-top: 1px solid var(--rule); padding: 0.5rem 0; }
summary { cursor: pointer; font-weight: 600; }
.faded { opacity: 0.12; }
.key { cursor: default; }
.live .key { cursor: pointer; }
.key:focus-visible, button:focus-visible, summary:focus-visible { outline: 3px solid var(--link); }
.tip { position: absolute; z-index: 2; pointer-events: none; padding: 0.15rem 0.5rem; font-size: 0.9rem;
  color: var(--paper); background: var(--ink); border-radius: 4px; white-space: nowrap; }
@media (max-width: 52rem) {
  body { font-size: 16px; padding: 0 0.9rem 2rem; }
  .first { grid-template-columns: minmax(0, 1fr); }
}
@media print {
  html { font-size: 10.5pt; }
  body { max-width: none; font-size: 1rem; padding: 0; }
  .switch, .tip { display: none; }
  .unchosen { display: block; }
  .trio figure, .panel, tr { break-inside: avoid; }
  h1, h2 { margin-top: 0.8rem; }
  h2 { padding-top: 0.6rem; }
  h2, h3 { break-after: avoid; }
  .first { display: block; }
  .first:not(:has(.panel + .panel)) { display: grid; gap: 0 1.2rem;
    grid-template-columns: minmax(0, 6fr) minmax(0, 5fr); }
  .panels { grid-template-columns: 1fr 1fr; }
  .first:not(:has(.panel + .panel)) .panels { grid-template-columns: 1fr; }
  .trio { grid-template-columns: 1fr 1fr 1fr; gap: 0 1rem; }
  .trio .panels { grid-template-columns: 1fr; }
}
)";
}

} // namespace granum::plot
