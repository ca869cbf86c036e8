#include "render/link/Token.h"

#include <QCryptographicHash>
#include <QMessageAuthenticationCode>
#include <QRandomGenerator>
#include <algorithm>
#include <cstring>

namespace sagara::link {

Nonce freshNonce() {
    std::array<quint32, 4> words;
    QRandomGenerator::system()->fillRange(words.data(), 4);
    Nonce nonce;
    std::memcpy(nonce.data(), words.data(), nonce.size());
    return nonce;
}

Proof proofOf(std::string_view token, const Nonce& nonce, std::string_view channel) {
    QMessageAuthenticationCode mac(QCryptographicHash::Sha256,
                                   QByteArray(token.data(), static_cast<qsizetype>(token.size())));
    mac.addData(reinterpret_cast<const char*>(nonce.data()), static_cast<qsizetype>(nonce.size()));
    mac.addData(channel.data(), static_cast<qsizetype>(channel.size()));
    const QByteArray result = mac.result();
    Proof proof{};
    std::memcpy(proof.data(), result.constData(),
                std::min(proof.size(), static_cast<std::size_t>(result.size())));
    return proof;
}

bool same(const Proof& a, const Proof& b) {
    std::byte difference{0};
    for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
    return difference == std::byte{0};
}

}  // namespace sagara::link
