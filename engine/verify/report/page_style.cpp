// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

namespace resonform::report {

// A table's rows become lists below 44rem, so that nothing is wider than a telephone. Figures are drawn on
// white: in the dark they are inverted, with their hues turned back. On paper everything that is folded is
// open.
const char* const page_style = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #22262b; --soft: #5a6068; --line: #e1e4e8; --box: #f6f7f9;
        --blue: #1f5fa8; --good: #2e7d4f; --bad: #c0392b; --open: #946000; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 72rem; color: var(--ink); background: var(--paper);
       font: 16px/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .25rem; }
.subtitle { color: var(--soft); margin: 0 0 1.2rem; }
a { color: var(--blue); }
nav { border-block: 1px solid var(--line); padding: .6rem 0; margin-bottom: 1.2rem; }
nav a { text-decoration: none; margin-right: 1.4rem; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .8rem; padding-top: .4rem; border-top: 2px solid var(--line); }
p { max-width: 46rem; }
.statements { list-style: none; margin: 0; padding: 0; max-width: 58rem; }
.statements li { display: grid; grid-template-columns: 7rem 1fr; padding: .4rem 0; border-bottom: 1px solid var(--line); }
.word { font-weight: 700; color: var(--soft); }
.pass, .wins { color: var(--good); font-weight: 700; } .fail, .loses { color: var(--bad); font-weight: 700; }
.undecided { color: var(--open); font-weight: 700; }
dl { margin: 1rem 0; }
dl div { display: grid; grid-template-columns: 12rem 1fr; padding: .25rem 0; border-bottom: 1px solid var(--line); }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
pre { background: var(--box); border: 1px solid var(--line); border-radius: 6px; padding: .9rem 1rem;
      white-space: pre-wrap; overflow-wrap: anywhere; font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.formulas { background: var(--box); border: 1px solid var(--line); border-radius: 6px; padding: .4rem 1rem;
            overflow-x: auto; margin: 1rem 0; }
.formulas p { max-width: none; margin: .6rem 0; }
.equation { padding-left: 2.5rem; text-indent: -2.5rem; }
math { text-indent: 0; font-size: 1.08em; }
.dots { font-size: 1em; math-depth: 0; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1.5rem; }
.gallery.small { grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); }
figure { margin: 0; min-width: 0; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: .9rem; padding: .2rem .2rem 0; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; margin: 1rem 0 1.6rem; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: right; padding: .3rem 0 .3rem .9rem; border-bottom: 1px solid var(--line); vertical-align: top; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
th { color: var(--soft); font-weight: 600; }
summary { font-weight: 600; font-size: .92rem; cursor: pointer; color: var(--blue); }
@media screen and (max-width: 44rem) {
  h1 { font-size: 1.5rem; }
  .statements li, dl div { grid-template-columns: 1fr; }
  .equation { padding-left: 1.2rem; text-indent: -1.2rem; } math { font-size: .85rem; }
  table, tbody, tr, td, caption { display: block; }
  thead { display: none; }
  tr { padding: .5rem 0; border-bottom: 2px solid var(--line); }
  td, td:first-child { text-align: left; border: 0; padding: .1rem 0; overflow-wrap: anywhere; }
  td:empty { display: none; }
  td[data-header]::before { content: attr(data-header) ": "; color: var(--soft); font-weight: 400; }
}
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #15181c; --ink: #e3e6ea; --soft: #a2a9b2; --line: #343a41; --box: #1d2126; --blue: #7fb2ef;
          --good: #6cc592; --bad: #f08a7d; --open: #e0ae4d; }
  figure svg { filter: invert(.91) hue-rotate(180deg); }
}
@media print {
  :root { color-scheme: light; }
  @page { margin: 15mm; }
  body { padding: 0; max-width: none; font-size: 10pt; }
  nav, .numbers { display: none; }
  h2 { break-after: avoid; }
  figure, tr, .statements li, dl div, .equation { break-inside: avoid; }
  caption { break-after: avoid; }
  details::details-content { content-visibility: visible; display: block; block-size: auto; }
  .gallery { grid-template-columns: 1fr 1fr; gap: .8rem; }
  .gallery.small { grid-template-columns: 1fr 1fr 1fr; }
  table { font-size: 8pt; } th, td { padding-left: .4rem; overflow-wrap: anywhere; }
  .formulas { overflow: visible; } math { font-size: 8.5pt; }
  pre { font-size: 7.5pt; }
}
)";

} // namespace resonform::report
