#include "apps/laws.h"

#include "apps/errors.h"

namespace apps {

void LawBook::check(const SceneSource& source) const {
  std::vector<std::string> mistakes;
  if (prony_terms() > most_prony_terms)
    mistakes.push_back(source.where("binder.alpha") + ": expected at most " +
                       std::to_string(most_prony_terms) + " Prony terms, found " +
                       std::to_string(prony_terms()) + "; leave out the least weights");
  if (damping() && (binder_ || fracture()))
    mistakes.push_back(
        source.where("stones.restitution") +
        ": expected no restitution where stones have binder or may break, found one; "
        "remove it, binder and fracture dissipate by themselves");
  if (!mistakes.empty()) throw InputError(mistakes);
}

}  // namespace apps
