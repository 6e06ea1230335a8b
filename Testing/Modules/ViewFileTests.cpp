#include "Widgets/Views/ViewFile.h"

#include <gtest/gtest.h>

namespace falciform {
namespace {

TEST(ViewFile, LooksComeBack) {
  ViewOptions saved, opened;
  saved.looks["preop"] = {false, {0.1, 0.2, 0.3}, 0.4};
  saved.looks["structure/portal vein"] = {true, {1, 0, 0.5}, 1};
  saved.patchLooks[7] = {false, {0.9, 0.8, 0.7}};
  saved.slicesWanted = true;
  saved.greyWindow = {60, 160};
  opened.looks["scan"] = {false, {0, 0, 0}, 0};  // of the case before
  readView(nlohmann::json::parse(toJson(saved).dump()), opened);
  EXPECT_EQ(opened.looks, saved.looks);
  EXPECT_EQ(opened.patchLooks, saved.patchLooks);
  EXPECT_TRUE(opened.slicesWanted);
  EXPECT_EQ(opened.greyWindow, saved.greyWindow);
}

TEST(ViewFile, WhatMakesNoSenseStaysAsItIs) {
  for (const char* text :
       {"{}", "[]", "7", R"({"parts": 3, "patches": [1]})",
        R"({"parts": {"preop": 4}, "patches": {"-1": {}, "300": {}, "one": {}, "2": 5}})"}) {
    ViewOptions options;
    readView(nlohmann::json::parse(text), options);
    EXPECT_TRUE(options.looks.empty() && options.patchLooks.empty()) << text;
  }
  ViewOptions options;
  readView(nlohmann::json::parse(R"({"parts": {"preop": {"visible": "yes", "colour": [1, 2], "opacity": 9}},
                                     "patches": {"2": {"colour": ["red", 0, 0]}}})"),
           options);
  EXPECT_EQ(options.looks.at("preop").visible, defaultLook("preop").visible);
  EXPECT_EQ(options.looks.at("preop").colour, defaultLook("preop").colour);
  EXPECT_EQ(options.looks.at("preop").opacity, 1) << "at most solid";
  EXPECT_EQ(options.patchLooks.at(2), ViewState().patchLook(2));
}

}  // namespace
}  // namespace falciform
