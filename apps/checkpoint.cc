#include "apps/checkpoint.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "apps/errors.h"
#include "apps/text.h"
#include "apps/whole_file.h"

namespace apps {
namespace {

constexpr std::string_view format = "gyratory checkpoint 1\n";

struct OtherScene : Unfit {
  using Unfit::Unfit;
};

struct Seal {
  std::uint64_t length, checksum;
};

// FNV-1a: every step maps different states to different states, so that no single wrong byte is
// overlooked.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t state = 14695981039346656037u;
  for (const char byte : bytes) state = (state ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  return state;
}

// The first line in which two scenes differ, as the first has it.
std::string difference(const std::string& one, const std::string& other) {
  std::istringstream lines(one), others(other);
  for (std::string line, twin; std::getline(lines, line);)
    if (!std::getline(others, twin) || twin != line) return '"' + line + '"';
  return "a line less";
}

}  // namespace

Checkpoints::Checkpoints(std::string folder, StoredScene scene)
    : folder_(std::move(folder)), scene_(std::move(scene)) {}

void Checkpoints::write(Archive archive) const {
  StoredScene scene = scene_;
  archive("scene", scene.text);
  archive("gradation", scene.gradation);
  const std::string items = archive.bytes();
  const Seal seal{items.size(), checksum(items)};
  std::string content(format);
  content.append(reinterpret_cast<const char*>(&seal), sizeof seal);
  content += items;
  const std::string newest = folder_ + "/checkpoint", older = newest + ".older";
  replace_whole_file(newest, content, older);
}

Archive Checkpoints::read(const std::string& path) const {
  const std::optional<std::string> content = read_text(path);
  if (!content) throw Unfit("it cannot be read");
  std::string_view rest = *content;
  if (!rest.starts_with(format)) throw Unfit("it does not begin as a checkpoint");
  rest.remove_prefix(format.size());
  Seal seal{};
  if (rest.size() < sizeof seal) throw Unfit("it ends within its head");
  std::memcpy(&seal, rest.data(), sizeof seal);
  rest.remove_prefix(sizeof seal);
  if (rest.size() != seal.length)
    throw Unfit("it has " + std::to_string(rest.size()) + " bytes of " +
                std::to_string(seal.length));
  if (checksum(rest) != seal.checksum) throw Unfit("it is damaged: its checksum is wrong");
  Archive archive(rest);
  StoredScene scene;
  archive("scene", scene.text);
  archive("gradation", scene.gradation);
  if (scene.text != scene_.text)
    throw OtherScene("it is of another scene, with " + difference(scene.text, scene_.text));
  if (scene.gradation != scene_.gradation) throw OtherScene("it is of another gradation");
  return archive;
}

std::optional<Archive> Checkpoints::newest(
    const std::function<void(const std::string&)>& tell) const {
  bool other_scene = false;
  for (const char* name : {"/checkpoint", "/checkpoint.older"}) {
    const std::string path = folder_ + name;
    std::error_code error;
    if (!std::filesystem::exists(path, error)) continue;
    try {
      return read(path);
    } catch (const OtherScene& reason) {
      tell(path + ": not taken, " + reason.what());
      other_scene = true;
    } catch (const Unfit& reason) {
      tell(path + ": not taken, " + reason.what());
      std::filesystem::rename(path, path + ".refused", error);  // never in the place of a sound one
    }
  }
  if (other_scene)
    throw OutputError(folder_ + ": expected a checkpoint of the scene in " + stored_scene_file +
                      ", found those of another; put the scene back or begin anew elsewhere");
  return std::nullopt;
}

}  // namespace apps
