#pragma once

#include "render/link/Check.h"
#include "render/link/Messages.h"
#include "render/link/Protocol.h"

namespace sagara::wire {
class Greeting;
class Hello;
class Refused;
class Welcome;
class Setup;
class Ready;
class Rendered;
class Show;
class Shown;
class Ping;
class Pong;
class Picture;
class Bye;
}  // namespace sagara::wire

/// Every message but Frame to and from the wire. A pair for each kind: how it is written, how it is read.
namespace sagara::link {

Kind write(const Greeting& message, wire::Greeting& wire);
Greeting read(const wire::Greeting& wire, Check& check);
Kind write(const Hello& message, wire::Hello& wire);
Hello read(const wire::Hello& wire, Check& check);
Kind write(const Refused& message, wire::Refused& wire);
Refused read(const wire::Refused& wire, Check& check);
Kind write(const Welcome& message, wire::Welcome& wire);
Welcome read(const wire::Welcome& wire, Check& check);
Kind write(const Setup& message, wire::Setup& wire);
Setup read(const wire::Setup& wire, Check& check);
Kind write(const Ready& message, wire::Ready& wire);
Ready read(const wire::Ready& wire, Check& check);
Kind write(const Rendered& message, wire::Rendered& wire);
Rendered read(const wire::Rendered& wire, Check& check);
Kind write(const Show& message, wire::Show& wire);
Show read(const wire::Show& wire, Check& check);
Kind write(const Shown& message, wire::Shown& wire);
Shown read(const wire::Shown& wire, Check& check);
Kind write(const Ping& message, wire::Ping& wire);
Ping read(const wire::Ping& wire, Check& check);
Kind write(const Pong& message, wire::Pong& wire);
Pong read(const wire::Pong& wire, Check& check);
Kind write(const Picture& message, wire::Picture& wire);
Picture read(const wire::Picture& wire, Check& check);
Kind write(const Bye& message, wire::Bye& wire);
Bye read(const wire::Bye& wire, Check& check);

}  // namespace sagara::link
