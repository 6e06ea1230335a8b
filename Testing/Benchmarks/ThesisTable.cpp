#include "Testing/Benchmarks/ThesisTable.h"

#include <cstdio>

namespace falciform::bench {
namespace {

struct Column {
  ErrorFigures MeasuredRow::*here;
  ThesisError UpdateRow::*thesis;
};
constexpr Column kColumns[] = {{&MeasuredRow::before, &UpdateRow::before},
                               {&MeasuredRow::fullRigid, &UpdateRow::fullRigid},
                               {&MeasuredRow::fullUpdated, &UpdateRow::fullUpdated},
                               {&MeasuredRow::partialRigid, &UpdateRow::partialRigid},
                               {&MeasuredRow::partialUpdated, &UpdateRow::partialUpdated}};

ErrorFigures figures(const ThesisError& e) { return {.mean = e.mean, .sd = e.sd, .largest = e.largest}; }

std::string cell(const ErrorFigures& e, bool spread) {
  return spread ? asInThesis(e) : withoutSpread(e, e.mean > 0 && e.mean < 0.1 ? 2 : 1);
}

}  // namespace

ErrorFigures meanOf(const std::vector<ErrorFigures>& all) {
  ErrorFigures mean;
  for (const ErrorFigures& e : all) {
    mean.mean += e.mean / static_cast<double>(all.size());
    mean.largest += e.largest / static_cast<double>(all.size());
  }
  return mean;
}

void printThesisTable(const std::string& rigid, const std::string& update,
                      const std::vector<MeasuredRow>& rows, std::span<const UpdateRow> thesis) {
  const bool spread = thesis.front().before.sd > 0;
  std::printf(
      "| trial | before | thesis | full: %s | thesis | full: %s | thesis | partial: %s | thesis | partial: "
      "%s "
      "| thesis |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      rigid.c_str(), update.c_str(), rigid.c_str(), update.c_str());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::printf("| %s |", rows[i].trial.c_str());
    for (const Column& c : kColumns)
      std::printf(" %s | %s |", cell(rows[i].*c.here, spread).c_str(),
                  cell(figures(thesis[i].*c.thesis), spread).c_str());
    std::puts("");
  }
  if (!spread) {
    std::printf("| mean |");
    for (const Column& c : kColumns) {
      std::vector<ErrorFigures> here, printed;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        here.push_back(rows[i].*c.here);
        printed.push_back(figures(thesis[i].*c.thesis));
      }
      std::printf(" %s | %s |", cell(meanOf(here), spread).c_str(), cell(meanOf(printed), spread).c_str());
    }
    std::puts("");
  }
  std::puts("");
  std::fflush(stdout);
}

}  // namespace falciform::bench
