#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace falciform::commandline {

/// The bytes of a file in base64.
[[nodiscard]] std::string base64OfFile(const std::filesystem::path& file);

/// A table; every cell is escaped. Columns from `firstNumber` on are set right-aligned; -1: none.
class HtmlTable {
 public:
  explicit HtmlTable(std::vector<std::string> head, int firstNumber = -1)
      : head_(std::move(head)), firstNumber_(firstNumber) {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string html() const;

 private:
  [[nodiscard]] std::string line(const std::vector<std::string>& cells, const char* element) const;

  std::vector<std::string> head_;
  int firstNumber_;
  std::vector<std::vector<std::string>> rows_;
};

/// `<section>` with a heading (escaped) and a body (HTML).
[[nodiscard]] std::string htmlSection(const std::string& heading, const std::string& body);
/// `<p>` with escaped text.
[[nodiscard]] std::string htmlParagraph(const std::string& text, const std::string& cssClass = "");

/// A picture held in the page, with its caption (escaped) under it.
[[nodiscard]] std::string htmlPicture(const std::filesystem::path& file, const std::string& caption);

/// A figure set large with what it means under it, both escaped; several stand in one `<div class="cards">`.
[[nodiscard]] std::string htmlCard(const std::string& figure, const std::string& meaning);
/// The warnings as a list, escaped; "No warnings." if there is none.
[[nodiscard]] std::string htmlWarnings(const std::vector<std::string>& warnings);

/// A whole page in one file: no links, light and dark, fit to print.
[[nodiscard]] std::string htmlPage(const std::string& title, const std::string& body);

}  // namespace falciform::commandline
