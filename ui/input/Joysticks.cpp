#include "ui/input/Joysticks.h"

#include <SDL.h>

#include <QTimer>
#include <algorithm>
#include <array>

namespace sagara::ui {
namespace {

constexpr int kPoll_ms = 20;

double scaled(Sint16 raw) { return raw < 0 ? raw / 32768.0 : raw / 32767.0; }

}  // namespace

struct Joysticks::Device {
    JoystickInfo info;
    SDL_Joystick* handle = nullptr;
    std::vector<Sint16> axes;
    std::vector<bool> buttons;
    bool fresh = true;  ///< where its axes stand has not been told yet

    ~Device() { SDL_JoystickClose(handle); }
    bool pressed(int index) const {
        if (index < info.buttons) return SDL_JoystickGetButton(handle, index) != 0;
        constexpr std::array<Uint8, 4> kWays{SDL_HAT_UP, SDL_HAT_RIGHT, SDL_HAT_DOWN, SDL_HAT_LEFT};
        const int way = index - info.buttons;
        return (SDL_JoystickGetHat(handle, way / 4) & kWays[static_cast<std::size_t>(way % 4)]) != 0;
    }
};

Joysticks::Joysticks(QObject* parent) : QObject(parent), m_timer(new QTimer(this)) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // SDL has no window of ours
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");                   // the kernel's drivers are enough
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK) != 0) {
        m_trouble = QString::fromUtf8(SDL_GetError());
        return;
    }
    SDL_JoystickEventState(SDL_IGNORE);  // looked at, not waited for
    connect(m_timer, &QTimer::timeout, this, &Joysticks::poll);
    m_timer->start(kPoll_ms);
}

Joysticks::~Joysticks() {
    m_devices.clear();
    if (m_trouble.isEmpty()) SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
}

std::vector<JoystickInfo> Joysticks::devices() const {
    std::vector<JoystickInfo> infos;
    for (const auto& device : m_devices) infos.push_back(device->info);
    return infos;
}

const Joysticks::Device* Joysticks::find(int id) const {
    for (const auto& device : m_devices)
        if (device->info.id == id) return device.get();
    return nullptr;
}

double Joysticks::axis(int id, int index) const {
    const Device* const device = find(id);
    if (device == nullptr || index < 0 || index >= device->info.axes) return 0.0;
    return scaled(device->axes[static_cast<std::size_t>(index)]);
}

bool Joysticks::button(int id, int index) const {
    const Device* const device = find(id);
    if (device == nullptr || index < 0 || index >= device->info.allButtons()) return false;
    return device->buttons[static_cast<std::size_t>(index)];
}

void Joysticks::lookForDevices() {
    for (std::size_t i = 0; i < m_devices.size();) {
        if (SDL_JoystickGetAttached(m_devices[i]->handle) == SDL_TRUE) {
            ++i;
            continue;
        }
        const JoystickInfo gone = m_devices[i]->info;
        m_devices.erase(m_devices.begin() + static_cast<std::ptrdiff_t>(i));
        Q_EMIT unplugged(gone.id, gone.name);
    }
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
        const int id = SDL_JoystickGetDeviceInstanceID(index);
        if (id < 0 || find(id) != nullptr) continue;
        auto device = std::make_unique<Device>();
        device->handle = SDL_JoystickOpen(index);
        if (device->handle == nullptr) continue;  // no permission, or gone again
        std::array<char, 40> guid{};
        SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(device->handle), guid.data(),
                                  static_cast<int>(guid.size()));
        const char* const name = SDL_JoystickName(device->handle);
        device->info = {id,
                        guid.data(),
                        name == nullptr ? tr("unnamed device") : QString::fromUtf8(name),
                        std::max(0, SDL_JoystickNumAxes(device->handle)),
                        std::max(0, SDL_JoystickNumButtons(device->handle)),
                        std::max(0, SDL_JoystickNumHats(device->handle))};
        device->axes.resize(static_cast<std::size_t>(device->info.axes));
        device->buttons.resize(static_cast<std::size_t>(device->info.allButtons()));
        m_devices.push_back(std::move(device));
        Q_EMIT plugged(id);
    }
}

void Joysticks::read(Device& device) {
    const int id = device.info.id;
    for (int i = 0; i < device.info.axes; ++i) {
        // Before it has been touched SDL reports 0, which is not where a lever stands.
        Sint16 start = 0;
        const Sint16 now = SDL_JoystickGetAxisInitialState(device.handle, i, &start) == SDL_TRUE
                               ? SDL_JoystickGetAxis(device.handle, i)
                               : start;
        const auto index = static_cast<std::size_t>(i);
        if (now == device.axes[index] && !device.fresh) continue;
        device.axes[index] = now;
        Q_EMIT axisMoved(id, i, scaled(now));
    }
    device.fresh = false;
    for (int i = 0; i < device.info.allButtons(); ++i) {
        const bool down = device.pressed(i);
        const auto index = static_cast<std::size_t>(i);
        if (down == device.buttons[index]) continue;
        device.buttons[index] = down;
        Q_EMIT buttonChanged(id, i, down);
    }
}

void Joysticks::poll() {
    if (!m_trouble.isEmpty()) return;
    SDL_JoystickUpdate();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // devices coming and going, which nobody reads
    lookForDevices();
    for (std::size_t i = 0; i < m_devices.size(); ++i) read(*m_devices[i]);
}

}  // namespace sagara::ui
