#include "VirtualStick.h"

#include <SDL.h>

#include <stdexcept>

namespace sagara::test {

VirtualStick::VirtualStick(int axes, int buttons, int hats) {
    const int index = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_FLIGHT_STICK, axes, buttons, hats);
    if (index < 0) throw std::runtime_error(SDL_GetError());
    m_id = SDL_JoystickGetDeviceInstanceID(index);
}

void VirtualStick::unplug() {
    if (m_id < 0) return;
    for (int i = 0; i < SDL_NumJoysticks(); ++i)
        if (SDL_JoystickGetDeviceInstanceID(i) == m_id) SDL_JoystickDetachVirtual(i);
    m_id = -1;
}

void VirtualStick::setAxis(int axis, double value) {
    SDL_JoystickSetVirtualAxis(SDL_JoystickFromInstanceID(m_id), axis, static_cast<Sint16>(32767.0 * value));
}
void VirtualStick::setButton(int button, bool down) {
    SDL_JoystickSetVirtualButton(SDL_JoystickFromInstanceID(m_id), button, down ? 1 : 0);
}
void VirtualStick::setHatUp(bool up) {
    SDL_JoystickSetVirtualHat(SDL_JoystickFromInstanceID(m_id), 0, up ? SDL_HAT_UP : SDL_HAT_CENTERED);
}

}  // namespace sagara::test
