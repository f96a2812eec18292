#include "apps/archive.h"

#include <cassert>
#include <cstdint>

namespace apps {
namespace {

void put(std::string& bytes, std::string_view text) {
  const std::uint64_t size = text.size();
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(text);
}

std::string_view take(std::string_view& bytes) {
  std::uint64_t size = 0;
  if (bytes.size() < sizeof size) throw Unfit("it ends within an item");
  std::memcpy(&size, bytes.data(), sizeof size);
  bytes.remove_prefix(sizeof size);
  if (bytes.size() < size) throw Unfit("it ends within an item");
  const std::string_view text = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return text;
}

}  // namespace

Archive::Archive(std::string_view bytes) : restores_(true) {
  while (!bytes.empty()) {
    const std::string name(take(bytes));
    items_[name] = take(bytes);
  }
}

std::string Archive::bytes() const {
  std::string bytes;
  for (const auto& [name, content] : items_) {
    put(bytes, name);
    put(bytes, content);
  }
  return bytes;
}

const std::string& Archive::found(const std::string& name) const {
  const auto item = items_.find(name);
  if (item == items_.end()) throw Unfit("it holds no \"" + name + "\"");
  return item->second;
}

std::size_t Archive::count(const std::string& name, std::size_t element, std::size_t now) const {
  return restores_ ? found(name).size() / element : now;
}

void Archive::exchange(const std::string& name, void* value, std::size_t size) {
  if (!restores_) {
    assert(!items_.contains(name));
    items_[name].assign(static_cast<const char*>(value), size);
    return;
  }
  const std::string& content = found(name);
  if (content.size() != size)
    throw Unfit("its \"" + name + "\" has " + std::to_string(content.size()) +
                " bytes, the run needs " + std::to_string(size));
  if (size > 0) std::memcpy(value, content.data(), size);
}

void Archive::operator()(const std::string& name, std::vector<std::vector<double>>& rows) {
  std::uint64_t count = rows.size();
  (*this)(name + ".rows", count);
  rows.resize(count);
  std::vector<double> flat;
  for (const std::vector<double>& row : rows) flat.insert(flat.end(), row.begin(), row.end());
  (*this)(name, flat);
  const std::size_t length = count > 0 ? flat.size() / count : 0;
  for (std::size_t r = 0; r < count; ++r)
    rows[r].assign(flat.begin() + r * length, flat.begin() + (r + 1) * length);
}

void Archive::operator()(const std::string& name, std::string& text) {
  text.resize(count(name, 1, text.size()));
  exchange(name, text.data(), text.size());
}

void Archive::operator()(const std::string& name, std::optional<double>& number) {
  std::vector<double> one;
  if (number) one.push_back(*number);
  (*this)(name, one);
  if (one.empty())
    number.reset();
  else
    number = one.front();
}

}  // namespace apps
