#pragma once
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace falciform {

/// Holds a slot's place in a Signal; the slot is dropped when the last copy of the connection goes.
using Connection = std::shared_ptr<void>;

/// A list of callbacks, called in the order of connection. One thread only.
template <class... Arguments>
class Signal {
 public:
  using Slot = std::function<void(Arguments...)>;

  /// Calls `slot` at every emission until the returned connection is destroyed.
  [[nodiscard]] Connection connect(Slot slot) {
    const int id = next_++;
    slots_->emplace(id, std::move(slot));
    return Connection(nullptr, [slots = std::weak_ptr(slots_), id](void*) {
      if (auto alive = slots.lock()) alive->erase(id);
    });
  }

  void emit(Arguments... arguments) const {
    const auto snapshot = *slots_;  // a slot may connect or disconnect
    for (const auto& [id, slot] : snapshot)
      if (slots_->count(id)) slot(arguments...);
  }

 private:
  std::shared_ptr<std::map<int, Slot>> slots_ = std::make_shared<std::map<int, Slot>>();
  int next_ = 0;
};

}  // namespace falciform
