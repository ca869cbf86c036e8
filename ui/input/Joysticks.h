#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <vector>

class QTimer;

namespace sagara::ui {

/// A joystick, wheel or gamepad that is plugged in.
struct JoystickInfo {
    int id = 0;         ///< as long as it is plugged in
    std::string model;  ///< the same for two of a kind: SDL's GUID as text
    QString name;
    int axes = 0;
    int buttons = 0;
    int hats = 0;
    int allButtons() const { return buttons + 4 * hats; }
};

/// What is plugged in, by SDL's joystick subsystem, looked at 50 times a second on the GUI thread. Works with
/// no device and through plugging in and out. One in a program: SDL's joysticks are the process's.
class Joysticks final : public QObject {
    Q_OBJECT

public:
    explicit Joysticks(QObject* parent = nullptr);
    ~Joysticks() override;

    /// Empty when SDL could be started; otherwise why not.
    const QString& trouble() const { return m_trouble; }
    std::vector<JoystickInfo> devices() const;
    /// -1 to 1; 0 for what is not there.
    double axis(int id, int index) const;
    bool button(int id, int index) const;

    /// Looks now; the timer does it by itself.
    void poll();

Q_SIGNALS:
    void plugged(int id);
    void unplugged(int id, const QString& name);
    void axisMoved(int id, int axis, double raw);
    void buttonChanged(int id, int button, bool down);

private:
    struct Device;
    void lookForDevices();
    void read(Device& device);
    const Device* find(int id) const;

    QString m_trouble;
    QTimer* m_timer;
    std::vector<std::unique_ptr<Device>> m_devices;
};

}  // namespace sagara::ui
