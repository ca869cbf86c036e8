#include "render/link/Handshake.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/exercise/BuildId.h"
#include "render/link/Token.h"

namespace sagara::link {
namespace {

std::string listOf(const std::vector<std::uint32_t>& versions) {
    std::string text;
    for (const std::uint32_t version : versions) text += (text.empty() ? "" : ", ") + std::to_string(version);
    return text.empty() ? "none" : text;
}

/// The next message if it is a T; else why not.
template <typename T>
core::Result<T, std::string> hear(Connection& connection, int patience_ms) {
    auto received = connection.wait(patience_ms);
    if (!received)
        return connection.isOpen() ? std::string("the station does not answer") : connection.whyClosed();
    if (const auto* refused = std::get_if<Refused>(&received->message)) {
        return "the station refuses: " + refused->reason +
               (refused->speaks.empty() ? "" : "; it speaks protocol version " + listOf(refused->speaks));
    }
    return std::get<T>(std::move(received->message));  // nothing else is expected
}

}  // namespace

core::Result<ChannelView, std::string> introduce(Connection& connection, const Introduction& who,
                                                 int patience_ms) {
    connection.expect(kBeforeGreeting);
    const auto greeted = hear<Greeting>(connection, patience_ms);
    if (!greeted) return greeted.error();
    const auto& speaks = greeted->speaks;
    if (std::find(speaks.begin(), speaks.end(), kProtocolVersion) == speaks.end())
        return "the station speaks protocol version " + listOf(speaks) + ", this program " +
               std::to_string(kProtocolVersion);
    connection.expect(kBeforeWelcome);
    connection.send(Hello{who.role, who.channel, proofOf(who.token, greeted->nonce, who.channel),
                          std::string(core::coreBuildId()),
                          static_cast<std::uint32_t>(QCoreApplication::applicationPid())});
    auto welcome = hear<Welcome>(connection, patience_ms);
    if (!welcome) return welcome.error();
    connection.expect(kFromStation);
    return std::move(welcome).value().view;
}

Greeting greeting() { return {{kProtocolVersion}, freshNonce(), std::string(core::coreBuildId())}; }

std::optional<std::string> objectionTo(const Hello& hello, const Nonce& nonce, const std::string& token) {
    if (!same(hello.proof, proofOf(token, nonce, hello.channel))) return "the token is wrong";
    if (hello.role == Role::Console) return "this station takes no consoles yet";
    return std::nullopt;
}

}  // namespace sagara::link
