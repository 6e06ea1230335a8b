#include "Logic/Core/Signal.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace falciform {

TEST(Signal, SlotsAreCalledInTheOrderOfConnectionWithTheArguments) {
  Signal<int, const std::string&> signal;
  std::vector<std::string> calls;
  const Connection a =
      signal.connect([&](int n, const std::string& s) { calls.push_back("a" + s + std::to_string(n)); });
  const Connection b =
      signal.connect([&](int n, const std::string& s) { calls.push_back("b" + s + std::to_string(n)); });
  signal.emit(1, "x");
  EXPECT_EQ(calls, (std::vector<std::string>{"ax1", "bx1"}));
}

TEST(Signal, ASlotGoesWithTheLastCopyOfItsConnection) {
  Signal<> signal;
  int calls = 0;
  Connection one = signal.connect([&] { ++calls; });
  Connection copy = one;
  one.reset();
  signal.emit();
  EXPECT_EQ(calls, 1);
  copy.reset();
  signal.emit();
  EXPECT_EQ(calls, 1);
}

TEST(Signal, AConnectionMayOutliveItsSignal) {
  Connection connection;
  {
    Signal<> signal;
    connection = signal.connect([] {});
  }
  EXPECT_NO_THROW(connection.reset());
}

TEST(Signal, ASlotMayDisconnectItselfDuringEmission) {
  Signal<> signal;
  int once = 0, always = 0;
  Connection self;
  self = signal.connect([&] {
    ++once;
    self.reset();
  });
  const Connection other = signal.connect([&] { ++always; });
  signal.emit();
  signal.emit();
  EXPECT_EQ(once, 1);
  EXPECT_EQ(always, 2);
}

TEST(Signal, ASlotDisconnectedByAnEarlierOneIsNotCalledAnyMore) {
  Signal<> signal;
  int calls = 0;
  Connection later;
  const Connection earlier = signal.connect([&] { later.reset(); });
  later = signal.connect([&] { ++calls; });
  signal.emit();
  EXPECT_EQ(calls, 0);
}

TEST(Signal, ASlotConnectedDuringEmissionIsCalledFromTheNextOneOn) {
  Signal<> signal;
  int calls = 0;
  std::vector<Connection> added;
  const Connection connection = signal.connect([&] { added.push_back(signal.connect([&] { ++calls; })); });
  signal.emit();
  EXPECT_EQ(calls, 0);
  signal.emit();
  EXPECT_EQ(calls, 1);
}

TEST(Signal, ASlotMayEmitTheSameSignalAgain) {
  Signal<int> signal;
  std::vector<int> depths;
  const Connection connection = signal.connect([&](int depth) {
    depths.push_back(depth);
    if (depth < 3) signal.emit(depth + 1);
  });
  signal.emit(1);
  EXPECT_EQ(depths, (std::vector<int>{1, 2, 3}));
}

}  // namespace falciform
