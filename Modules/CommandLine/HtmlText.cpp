#include "Modules/CommandLine/HtmlText.h"

#include "Logic/IO/OutputFile.h"
#include "Modules/CommandLine/SlicerXml.h"

namespace falciform::commandline {

namespace {

constexpr char kStyle[] = R"(
:root { color-scheme: light dark; --ink: #1c2126; --soft: #57606a; --paper: #ffffff; --panel: #f4f6f8; --line: #d8dee4;
  --accent: #14697a; --warn: #7a4d00; --warn-paper: #fff5dc; --banner: #5b1420; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ec; --soft: #9aa5b1; --paper: #15191d; --panel: #1e242a;
  --line: #343c44; --accent: #6cc5d6; --warn: #ffd27a; --warn-paper: #33290f; --banner: #6d1c2a; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
.banner { background: var(--banner); color: #fff; text-align: center; padding: .35rem; font-weight: 600; letter-spacing: .02em; }
main { max-width: 1120px; margin: 0 auto; padding: 1.5rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; margin: .5rem 0 0; line-height: 1.2; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .7rem; padding-bottom: .3rem; border-bottom: 2px solid var(--line); }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
p { margin: .4rem 0; max-width: 50rem; }
.soft, figcaption { color: var(--soft); font-size: .88rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(165px, 1fr)); gap: .8rem; margin: 1.4rem 0; }
.card { background: var(--panel); border: 1px solid var(--line); border-radius: 8px; padding: .8rem 1rem; }
.card b { display: block; font-size: 1.5rem; font-weight: 650; font-variant-numeric: tabular-nums; color: var(--accent); }
.card span { display: block; font-size: .82rem; color: var(--soft); line-height: 1.35; }
.warnings { background: var(--warn-paper); border-left: 4px solid var(--warn); border-radius: 4px; padding: .6rem 1rem .6rem 2rem; margin: 1rem 0; }
.warnings li { margin: .2rem 0; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 1.2rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; background: #fff; display: block; }
figcaption { margin-top: .35rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; margin: .4rem 0 1rem; }
th, td { text-align: left; padding: .32rem .7rem; border-bottom: 1px solid var(--line); vertical-align: top; overflow-wrap: anywhere; }
th { background: var(--panel); font-weight: 600; overflow-wrap: normal; } tbody tr:hover { background: var(--panel); }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; overflow-wrap: normal; }
footer { margin-top: 3rem; color: var(--soft); font-size: .85rem; border-top: 1px solid var(--line); padding-top: .8rem; }
@media (max-width: 520px) { .pictures { grid-template-columns: 1fr; } main { padding: 1rem; } }
@media print { :root { --ink: #000; --soft: #444; --paper: #fff; --panel: #f4f4f4; --line: #bbb; --accent: #0d4d5a; --warn: #7a4d00;
  --warn-paper: #fff; --banner: #5b1420; } .banner { color: #000; background: #fff; border-bottom: 2px solid #000; }
  main { max-width: none; padding: 0 .5rem; } body { font-size: 11pt; } .pictures { grid-template-columns: 1fr 1fr; }
  figure, .card, tr, .warnings { break-inside: avoid; } h2, h3 { break-after: avoid; } }
)";

}  // namespace

std::string base64OfFile(const std::filesystem::path& file) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = readTextFile(file);
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k < bytes.size() + 1 ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string HtmlTable::line(const std::vector<std::string>& cells, const char* element) const {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool number = firstNumber_ >= 0 && static_cast<int>(i) >= firstNumber_;
    html += std::string("<") + element + (number ? " class=\"n\">" : ">") + escaped(cells[i]) + "</" +
            element + ">";
  }
  return html + "</tr>\n";
}

std::string HtmlTable::html() const {
  std::string html = "<div class=\"scroll\"><table>\n<thead>" + line(head_, "th") + "</thead>\n<tbody>\n";
  for (const auto& cells : rows_) html += line(cells, "td");
  return html + "</tbody></table></div>\n";
}

std::string htmlSection(const std::string& heading, const std::string& body) {
  return "<section><h2>" + escaped(heading) + "</h2>\n" + body + "</section>\n";
}

std::string htmlParagraph(const std::string& text, const std::string& cssClass) {
  return (cssClass.empty() ? "<p>" : "<p class=\"" + cssClass + "\">") + escaped(text) + "</p>\n";
}

std::string htmlPicture(const std::filesystem::path& file, const std::string& caption) {
  const std::string text = escaped(caption);
  return "<figure><img alt=\"" + text + "\" src=\"data:image/png;base64," + base64OfFile(file) +
         "\"><figcaption>" + text + "</figcaption></figure>\n";
}

std::string htmlCard(const std::string& figure, const std::string& meaning) {
  return "<div class=\"card\"><b>" + escaped(figure) + "</b><span>" + escaped(meaning) + "</span></div>\n";
}

std::string htmlWarnings(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return htmlParagraph("No warnings.", "soft");
  std::string html = "<ul class=\"warnings\">\n";
  for (const std::string& warning : warnings) html += "<li>" + escaped(warning) + "</li>\n";
  return html + "</ul>\n";
}

std::string htmlPage(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" + body +
         "</body>\n</html>\n";
}

}  // namespace falciform::commandline
