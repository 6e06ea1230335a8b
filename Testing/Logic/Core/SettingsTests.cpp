#include "Logic/Core/Settings.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace falciform {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

enum class Order { First, Second, Third };
std::span<const std::string_view> enumNames(Order) {
  static constexpr std::array<std::string_view, 3> names{"first", "second", "third"};
  return names;
}

struct Sample {
  double radiusMm = 5;
  int iterations = 10;
  bool smooth = true;
  Order order = Order::Second;
  std::string name = "liver";
  std::vector<int> labels{1, 2};
};

template <class Visitor>
void describe(Sample& s, Visitor&& field) {
  field(FieldInfo{"radiusMm", "Radius", "mm", 1, 50, "Reach."}, s.radiusMm);
  field(FieldInfo{"iterations", "Iterations", "", 0, 100, "Steps."}, s.iterations);
  field(FieldInfo{"smooth", "Smooth", "", 0, 1, "Or not."}, s.smooth);
  field(FieldInfo{"order", "Order", "", 0, 0, "Which."}, s.order);
  field(FieldInfo{"name", "Name", "", 0, 0, "Whose."}, s.name);
  field(FieldInfo{"labels", "Labels", "", 0, 65535, "Values."}, s.labels);
}

template <class Work>
std::string refusalOf(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

std::string refusal(const nlohmann::json& json) {
  return refusalOf([&] { (void)settingsFromJson<Sample>(json); });
}

}  // namespace

TEST(Settings, JsonRoundTripKeepsEveryKindOfValue) {
  const Sample changed{7.25, 99, false, Order::Third, "scan \"two\"", {3, 1, 4}};
  const Sample back = settingsFromJson<Sample>(nlohmann::json::parse(settingsToJson(changed).dump()));
  EXPECT_EQ(back.radiusMm, 7.25);
  EXPECT_EQ(back.iterations, 99);
  EXPECT_FALSE(back.smooth);
  EXPECT_EQ(back.order, Order::Third);
  EXPECT_EQ(back.name, "scan \"two\"");
  EXPECT_EQ(back.labels, (std::vector<int>{3, 1, 4}));
  EXPECT_EQ(settingsToJson(changed)["order"], "third") << "an enum is stored by its name";
}

TEST(Settings, KeysThatAreNotGivenKeepTheirDefaults) {
  const Sample back = settingsFromJson<Sample>({{"iterations", 3}});
  EXPECT_EQ(back.iterations, 3);
  EXPECT_EQ(back.radiusMm, 5);
  EXPECT_EQ(back.order, Order::Second);
}

TEST(Settings, BothEndsOfARangeAreAllowedAndNothingBeyond) {
  EXPECT_EQ(settingsFromJson<Sample>({{"radiusMm", 1}}).radiusMm, 1);
  EXPECT_EQ(settingsFromJson<Sample>({{"radiusMm", 50}}).radiusMm, 50);
  for (const double beyond : {0.999, 50.001, -1.0})
    EXPECT_THAT(refusal({{"radiusMm", beyond}}), AllOf(HasSubstr("radiusMm"), HasSubstr("[1, 50] mm")));
  EXPECT_THAT(refusal({{"iterations", 101}}), HasSubstr("[0, 100]"));
}

TEST(Settings, CheckRefusesWhatCodeMaySetButJsonCannotSay) {
  Sample sample;
  EXPECT_NO_THROW(checkSettings(sample));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    sample.radiusMm = bad;
    EXPECT_THAT(refusalOf([&] { checkSettings(sample); }), HasSubstr("radiusMm"));
  }
}

TEST(Settings, UnknownKeysAreNamedWithTheKnownOnes) {
  EXPECT_THAT(refusal({{"radius", 3}}),
              AllOf(HasSubstr("'radius'"), HasSubstr("radiusMm"), HasSubstr("labels")));
}

TEST(Settings, UnknownNamesOfAnEnumAreRefusedWithTheChoice) {
  EXPECT_THAT(refusal({{"order", "fourth"}}),
              AllOf(HasSubstr("'fourth'"), HasSubstr("first, second or third")));
  EXPECT_EQ(enumFromString<Order>("order", enumToString(Order::First)), Order::First);
}

TEST(Settings, ValuesOfTheWrongKindAreRefused) {
  EXPECT_THAT(refusal({{"radiusMm", "wide"}}), HasSubstr("a number"));
  EXPECT_THAT(refusal({{"iterations", 2.5}}), HasSubstr("a whole number"));
  EXPECT_THAT(refusal({{"smooth", 1}}), HasSubstr("true or false"));
  EXPECT_THAT(refusal({{"order", 2}}), HasSubstr("first, second or third"));
  EXPECT_THAT(refusal({{"name", 5}}), HasSubstr("a text"));
  EXPECT_THAT(refusal({{"labels", "1,2"}}), HasSubstr("a list of whole numbers"));
  EXPECT_THAT(refusal(nlohmann::json::array()), HasSubstr("JSON object"));
}

TEST(Settings, WholeNumbersTooLargeForAnIntAreRefusedNotWrapped) {
  EXPECT_THAT(refusal({{"iterations", 4294967301}}), HasSubstr("iterations"));  // 2^32 + 5
}

TEST(Settings, ListsHoldWholeNumbersWithinTheirRange) {
  EXPECT_THAT(refusal({{"labels", {1.5}}}), HasSubstr("a list of whole numbers"));
  EXPECT_THAT(refusal({{"labels", {4294967301}}}), HasSubstr("labels"));
  EXPECT_THAT(refusal({{"labels", {1, 70000}}}), HasSubstr("[0, 65535]"));
  EXPECT_THAT(refusal({{"labels", {-1}}}), HasSubstr("labels"));
}

}  // namespace falciform
