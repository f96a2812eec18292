// A file written whole: whoever reads it, and a kill or a full disk at any moment, meets the old
// content or the new one, never a part.
#pragma once

#include <string>
#include <string_view>

namespace apps {

// Replaces `path` by `content`; throws OutputError and leaves the old file where that fails.
void write_whole_file(const std::string& path, std::string_view content);

// The same, and the old file is there as `older` from then on. A kill between the two renamings
// leaves only `older`.
void replace_whole_file(const std::string& path, std::string_view content,
                        const std::string& older);

// Creates `path`, empty; throws OutputError if something is there already.
void claim_new_file(const std::string& path);

}  // namespace apps
