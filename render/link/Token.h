#pragma once

#include <string_view>

#include "render/link/Messages.h"

/// The shared token that channels on other PCs must know. It never travels: the station greets with a number
/// used once, and the channel proves that it can sign it. What is drawn travels in the clear.
namespace sagara::link {

inline constexpr std::size_t kShortestToken = 8;

Nonce freshNonce();
Proof proofOf(std::string_view token, const Nonce& nonce, std::string_view channel);
/// In a time that does not tell where they differ.
bool same(const Proof& a, const Proof& b);

}  // namespace sagara::link
