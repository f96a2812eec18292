// The state of a run as named items, for a checkpoint: the same call, item(name, value), puts a
// value in while the run is stored and hands it back while it is restored, so that no list of
// members is written twice. A value is a number, a plain struct of numbers, a text, or an array.
#pragma once

#include <Eigen/Dense>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace apps {

// The items are not those that the run asks for.
struct Unfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Archive {
 public:
  Archive() = default;  // empty, to be filled
  // What bytes() of another archive gave, to be handed back. Throws Unfit.
  explicit Archive(std::string_view bytes);

  std::string bytes() const;
  bool restores() const { return restores_; }

  template <class T>
  void operator()(const std::string& name, T& value) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    exchange(name, &value, sizeof(T));
  }

  template <class T, class Allocator>
  void operator()(const std::string& name, std::vector<T, Allocator>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    values.resize(count(name, sizeof(T), values.size()));
    exchange(name, values.data(), sizeof(T) * values.size());
  }

  // Rows of the same length.
  void operator()(const std::string& name, std::vector<std::vector<double>>& rows);
  void operator()(const std::string& name, std::string& text);
  void operator()(const std::string& name, std::optional<double>& number);

  // Of the size that it has already.
  template <int Rows, int Columns>
  void operator()(const std::string& name, Eigen::Matrix<double, Rows, Columns>& matrix) {
    exchange(name, matrix.data(), sizeof(double) * static_cast<std::size_t>(matrix.size()));
  }

 private:
  // Copies the bytes of the item in or out; Unfit if there are not so many.
  void exchange(const std::string& name, void* value, std::size_t size);
  // Elements of an item: `now` while it is put in.
  std::size_t count(const std::string& name, std::size_t element, std::size_t now) const;
  const std::string& found(const std::string& name) const;

  std::map<std::string, std::string> items_;
  bool restores_ = false;
};

}  // namespace apps
