/// What must hold of any right answer, in sentences for who signs the design.
#pragma once

#include "engine/study/trust.h"

#include <string>
#include <vector>

namespace hanei {

/// Words with places for figures, so that they can be said in another language.
struct TrustSentence {
    std::string words;                 ///< "{} lm emitted, {} lm arrive"; empty: nothing to say
    std::vector<std::string> figures;  ///< one a place
    std::string english() const;
};

/// One check: what must hold, what was found, what is allowed and why, what else there is to say of it, and what
/// to do when it fails.
struct TrustRow {
    const char* name = "";  ///< "Energy"
    const char* must = "";  ///< hold, of any right answer
    TrustState state = TrustState::not_asked;
    TrustSentence found{}, allowed{};
    std::vector<TrustSentence> notes{};
    TrustSentence advice{};  ///< empty while it holds
};
std::vector<TrustRow> trust_rows(const TrustReport& report);  ///< those that are done

const char* name_of(TrustState state);  ///< "holds", "fails", "does not apply"

/// "5 of 6 checks hold, 1 does not apply." What is not asked does not count against the answer.
TrustSentence trust_verdict(const TrustReport& report);

std::string trust_text(const TrustReport& report);
std::string trust_json(const TrustReport& report);

}  // namespace hanei
