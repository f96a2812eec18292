#include "apps/laws.h"

#include <fmt/format.h>

#include "apps/errors.h"

namespace apps {

void LawBook::check(const SceneSource& source) const {
  std::vector<std::string> mistakes;
  if (prony_terms() > most_prony_terms)
    mistakes.push_back(source.where("binder.alpha") + ": expected at most " +
                       std::to_string(most_prony_terms) + " Prony terms, found " +
                       std::to_string(prony_terms()) + "; leave out the least weights");
  if (rings() && prony_terms() > 2)
    mistakes.push_back(source.where("binder.film") +
                       ": expected at most 2 Prony terms with rings, found " +
                       std::to_string(prony_terms()) + "; take \"even\", or leave out terms");
  if (shell_ > thickest_)
    mistakes.push_back(source.where("binder.content") +
                       fmt::format(": expected shells no thicker than {} x the radius of the "
                                   "smallest stone, {:.3g} mm, found {:.3g} mm; lower it, or raise "
                                   "stones.smallest",
                                   thickest_shell, 1e3 * thickest_, 1e3 * shell_));
  if (damping() && (binder_ || fracture()))
    mistakes.push_back(
        source.where("stones.restitution") +
        ": expected no restitution where stones have binder or may break, found one; "
        "remove it, binder and fracture dissipate by themselves");
  if (!mistakes.empty()) throw InputError(mistakes);
}

}  // namespace apps
