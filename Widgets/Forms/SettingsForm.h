#pragma once
#include <QWidget>
#include <algorithm>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "Logic/Core/Settings.h"

namespace falciform {

/// The form of a settings struct, built from its describe(): one row a field, the control named after the
/// key, unit as suffix, tooltip with help, unit, range and default. Controls write to the struct at once;
/// refresh() reads it back.
class SettingsForm : public QWidget {
  Q_OBJECT

 public:
  /// `settings` must outlive the form. Fields named in `shown` stand open, in that order of the struct; the
  /// others fold away under "More settings". An empty `shown` shows all.
  template <class S>
  explicit SettingsForm(S& settings, std::initializer_list<std::string_view> shown = {},
                        std::initializer_list<std::string_view> leftOut = {}, QWidget* parent = nullptr)
      : SettingsForm(parent) {
    const auto isIn = [](const auto& list, std::string_view key) {
      return std::find(list.begin(), list.end(), key) != list.end();
    };
    S defaults;
    describe(settings, [&]<class T>(const FieldInfo& info, T& value) {
      if (isIn(leftOut, info.key)) return;
      T standard = value;
      describe(defaults, [&]<class U>(const FieldInfo& other, U& found) {
        if constexpr (std::is_same_v<T, U>)
          if (other.key == info.key) standard = found;
      });
      const bool open = shown.size() == 0 || isIn(shown, info.key);
      addReset([&value, standard] { value = standard; });
      if constexpr (NamedEnum<T>) {
        addChoice(
            info, open, enumNames(T{}), static_cast<int>(standard),
            [&value] { return static_cast<int>(value); },
            [&value](int index) { value = static_cast<T>(index); });
      } else {
        add(info, open, value, standard);
      }
    });
    finish();
  }
  ~SettingsForm() override;

  /// Settings -> controls, without announcing.
  void refresh();
  /// Every field of the form to its default, announced.
  void resetToDefaults();
  /// Unfolds or folds "More settings".
  void setMoreShown(bool shown);

 Q_SIGNALS:
  /// A control changed the setting `key`; empty after a reset.
  void edited(const QString& key);

 private:
  explicit SettingsForm(QWidget* parent);
  void add(const FieldInfo& info, bool open, bool& value, bool standard);
  void add(const FieldInfo& info, bool open, int& value, int standard);
  void add(const FieldInfo& info, bool open, double& value, double standard);
  void add(const FieldInfo& info, bool open, std::string& value, const std::string& standard);
  void add(const FieldInfo& info, bool open, std::vector<int>& value, const std::vector<int>& standard);
  void addChoice(const FieldInfo& info, bool open, std::span<const std::string_view> names, int standard,
                 std::function<int()> get, std::function<void(int)> set);
  void addReset(std::function<void()> reset);
  void addRow(const FieldInfo& info, bool open, QWidget* control, const QString& standard,
              std::function<void()> refreshControl);
  void finish();

  struct Rows;
  std::unique_ptr<Rows> rows_;
};

}  // namespace falciform
