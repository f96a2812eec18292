#include "apps/study.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include "apps/parameters.h"
#include "apps/text.h"

namespace apps {
namespace {

struct Numbers {
  std::vector<double> seeds;
};

std::vector<Section> describe(Study& study, Numbers& numbers) {
  return {{"study",
           "What is run.",
           {{&study.program,
             "program",
             pure,
             unbounded,
             "that runs the scene",
             "",
             required("\"gyratory\""),
             {"gyratory", "flow_test"}},
            {&study.scene, "scene", pure, unbounded, "from the folder of the study", "",
             required("\"scene.toml\"")},
            {&numbers.seeds, "seeds", pure, unbounded, "one run each, of every setting", "",
             required("[1, 2, 3]")},
            {&study.reference, "reference", pure, unbounded,
             "name of the setting that errors are counted from", "", required("\"reference\"")}}},
          {"base", "Keys of the scene, for all settings.", {}}};
}

// Lays the keys of the scene that stand below a section of the study over those of the setting.
void take_keys(const Document& document, const std::string& section, Setting& setting) {
  const std::string prefix = section + '.';
  const auto take = [&](const std::string& key, const std::string& value, const Place& place) {
    setting.overrides.push_back(key + '=' + value);
    setting.places.insert_or_assign(key, place);
  };
  for (const auto& [name, place] : document.removed)
    if (name.starts_with(prefix)) take(name.substr(prefix.size()), "none", place);
  for (const auto& [name, value] : document.values) {
    if (!name.starts_with(prefix)) continue;
    const std::string key = name.substr(prefix.size());
    const std::string* word = std::get_if<std::string>(&value.content);
    if (key != "name" || section == "base")
      take(key, word && *word == "none" ? *word : value.written, value.key);
  }
}

void refuse_seed(const Document& document, const std::string& section, Mistakes& mistakes) {
  if (const Value* seed = document.find(section + ".run.seed"))
    mistakes.add(seed->key, "all seeds in study.seeds", "run.seed = " + seed->written,
                 "remove it, every setting runs with the same seeds");
}

void read_settings(Study& study, const Document& document, Mistakes& mistakes) {
  Setting base;
  take_keys(document, "base", base);
  refuse_seed(document, "base", mistakes);
  for (std::size_t k = 0; k < document.repetitions("setting"); ++k) {
    const std::string section = repeated("setting", k);
    refuse_seed(document, section, mistakes);
    const Value* value = document.find(section + ".name");
    const std::string* name = value ? std::get_if<std::string>(&value->content) : nullptr;
    if (!name || name->empty()) {
      mistakes.add(document.place(section + ".name"), "for setting.name a word in quotes",
                   value ? value->written : "nothing", "write it like name = \"draft\"");
      continue;
    }
    Setting setting = base;
    setting.name = *name;
    setting.word = as_word(*name);
    take_keys(document, section, setting);
    if (setting.word.empty() || setting.word == "." || setting.word == "..")
      mistakes.add(value->place, "a name that a folder can have", value->written, "choose another");
    if (std::ranges::find(study.settings, setting.word, &Setting::word) != study.settings.end())
      mistakes.add(value->place, "a name whose folder, " + setting.word + ", none above has",
                   value->written, "choose another");
    study.settings.push_back(std::move(setting));
  }
}

void refuse_section(const std::string& name, const Place& place, Mistakes& mistakes) {
  const std::string word = name.substr(0, name.find('['));
  if (word == "setting" && name != word)
    return mistakes.add(place, "one of the settings, counted from setting[0]", name,
                        "write it below [[setting]] instead");
  const auto meant = nearest(word, {"study", "base", "setting"});
  std::string advice = "remove it";
  if (meant)
    advice = "did you mean " + (*meant == "setting" ? "[[setting]]" : '[' + *meant + ']') + '?';
  mistakes.add(place, "one of the sections [study], [base] and [[setting]]",
               name == word ? '[' + name + ']' : "[[" + word + "]]", advice);
}

// Takes out what is for the program of the scene to check, and sections that no study has.
void take_out_sections(Document& own, Mistakes& mistakes) {
  std::set<std::string> known = {"study", "base"};
  for (std::size_t k = 0; k < own.repetitions("setting"); ++k) known.insert(repeated("setting", k));
  std::erase_if(own.sections, [&](const auto& section) {
    const auto& [name, place] = section;
    const bool is_refused = name.find('.') == std::string::npos && !known.contains(name);
    if (is_refused) refuse_section(name, place, mistakes);
    return is_refused;
  });
  const auto of_scene = [](const auto& item) {
    return item.first.starts_with("base.") || item.first.starts_with("setting[");
  };
  std::erase_if(own.sections, of_scene);
  std::erase_if(own.values, of_scene);
  std::erase_if(own.removed, [&](const auto& item) {
    return of_scene(item) && item.first.find('.') != std::string::npos;
  });
}

void check(const Study& study, const Numbers& numbers, const Document& document,
           Mistakes& mistakes) {
  if (study.settings.empty())
    mistakes.add({document.path, 1, 1}, "a section [[setting]]", "none", "add some");
  if (const Value* seeds = document.find("study.seeds")) {
    const auto is_seed = [](double seed) {
      return seed == std::floor(seed) && seed >= 0 && seed <= std::numeric_limits<int>::max();
    };
    if (!std::ranges::all_of(numbers.seeds, is_seed))
      mistakes.add(seeds->place, "for study.seeds whole numbers from 0 to 2147483647",
                   seeds->written, "write for example seeds = [1, 2, 3]");
    if (std::set(numbers.seeds.begin(), numbers.seeds.end()).size() < numbers.seeds.size())
      mistakes.add(seeds->place, "for study.seeds no number twice", seeds->written,
                   "a run that is counted twice scatters too little");
  }
  const Value* reference = document.find("study.reference");
  if (reference && !study.settings.empty() &&
      std::ranges::find(study.settings, study.reference, &Setting::name) == study.settings.end())
    mistakes.add(reference->place, "for study.reference the name of a setting", reference->written,
                 "name one of the sections [[setting]]");
}

}  // namespace

std::string all_of_scene(const std::string& path, const std::vector<std::string>& overrides) {
  Mistakes told_by_its_program;
  const Document scene = read_document(path, overrides, told_by_its_program);
  std::string text;
  for (const auto& [name, place] : scene.sections) text += '[' + name + "]\n";
  for (const auto& [key, value] : scene.values) text += key + " = " + value.written + '\n';
  const std::string gradation = "stones.gradation";
  const Value* table = scene.find(gradation);
  const std::string* file = table ? std::get_if<std::string>(&table->content) : nullptr;
  if (file) text += read_text(scene.path_from(gradation, *file)).value_or("");
  return text;
}

std::string as_word(const std::string& name) {
  std::string word = name;
  std::erase(word, ',');
  std::ranges::replace_if(
      word, [](unsigned char c) { return !std::isalnum(c) && c != '.' && c != '-'; }, '_');
  return word;
}

const Setting& Study::reference_setting() const {
  return *std::ranges::find(settings, reference, &Setting::name);
}

Study read_study(const std::string& path, const std::vector<std::string>& overrides) {
  const UnitSystem units;
  Mistakes mistakes;
  const Document document = read_document(path, overrides, mistakes);
  Study study;
  Numbers numbers;
  Document own = document;
  take_out_sections(own, mistakes);
  read_sections(describe(study, numbers), own, units, mistakes);
  read_settings(study, document, mistakes);
  check(study, numbers, document, mistakes);
  if (document.find("study.scene")) {
    const std::string scene = document.path_from("study.scene", study.scene);
    if (!read_text(scene))
      mistakes.add(document.place("study.scene"), "for study.scene a file", '"' + scene + '"',
                   "give its path from the folder of the study");
    study.scene = scene;
  }
  if (mistakes.any()) throw InputError(mistakes.lines());
  study.path = document.path;
  study.text = document.text;
  for (const double seed : numbers.seeds) study.seeds.push_back(static_cast<int>(seed));
  return study;
}

}  // namespace apps
