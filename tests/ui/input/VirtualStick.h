#pragma once

namespace sagara::test {

/// A joystick that SDL makes up, plugged in while it lives.
class VirtualStick final {
public:
    VirtualStick(int axes, int buttons, int hats);
    ~VirtualStick() { unplug(); }
    VirtualStick(const VirtualStick&) = delete;
    VirtualStick& operator=(const VirtualStick&) = delete;

    void unplug();
    void setAxis(int axis, double value);
    void setButton(int button, bool down);
    void setHatUp(bool up);

private:
    int m_id = -1;
};

}  // namespace sagara::test
