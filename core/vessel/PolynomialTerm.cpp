#include <algorithm>
#include <sstream>

#include "core/vessel/PolynomialModel.h"

namespace sagara::core {
namespace {

using Factor = PolynomialTerm::Factor;

struct NamedFactor {
    const char* name;
    Factor factor;
};
constexpr NamedFactor kFactors[] = {
    {"1", Factor::One},        {"u", Factor::Surge},
    {"v", Factor::Sway},       {"r", Factor::YawRate},
    {"p", Factor::RollRate},   {"phi", Factor::Roll},
    {"delta", Factor::Rudder}, {"c", Factor::Inflow},
    {"n", Factor::Shaft},      {"atan(v/u)", Factor::Sideslip},
    {"z", Factor::Depth},
};

std::optional<Factor> findFactor(const std::string& name) {
    const bool bars = name.size() > 2 && name.front() == '|' && name.back() == '|';
    const std::string bare = bars ? name.substr(1, name.size() - 2) : name;
    for (const NamedFactor& f : kFactors)
        if (bare == f.name) return bars ? absolute(f.factor) : f.factor;
    return std::nullopt;
}

}  // namespace

bool PolynomialTerm::has(Factor factor) const {
    return std::any_of(factors.begin(), factors.end(),
                       [&](Factor f) { return f == factor || f == absolute(factor); });
}

bool parseFactors(const std::string& text, std::array<Factor, PolynomialTerm::kFactors>& factors) {
    factors = {};
    std::size_t count = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::size_t times = 1;
        if (word.size() > 2 && word[word.size() - 2] == '^') {
            const char digit = word.back();
            if (digit < '2' || digit > '4') return false;
            times = static_cast<std::size_t>(digit - '0');
            word.resize(word.size() - 2);
        }
        const std::optional<Factor> factor = findFactor(word);
        if (!factor) return false;
        for (std::size_t i = 0; i < times; ++i) {
            if (count == factors.size()) return false;
            factors[count++] = *factor;
        }
    }
    return count > 0;
}

}  // namespace sagara::core
