#pragma once

#include <string>

namespace sagara::ui {

/// The PIN that ends an exhibition. A wrong one waits before the next try, longer each time. Not a safe: it
/// keeps visitors in, not burglars out. No clock, no Qt.
class DemoLock final {
public:
    static constexpr double kClosesAfter_s = 30.0;  ///< untouched
    static constexpr double kFirstWait_s = 3.0, kLongestWait_s = 60.0;
    static constexpr std::size_t kMostDigits = 8;

    /// Anything but 1 to 8 digits is taken as "0000".
    explicit DemoLock(std::string pin);

    void open();
    void close();
    bool isOpen() const { return m_open; }
    /// True when the PIN is complete and right. Nothing is taken while it waits.
    bool type(char digit);
    void erase();
    void advance(double elapsed_s);

    std::size_t typed() const { return m_typed.size(); }
    std::size_t digits() const { return m_pin.size(); }
    double waits_s() const { return m_wait_s; }  ///< 0: digits are taken
    bool wasWrong() const { return m_wrong > 0; }

private:
    std::string m_pin;
    std::string m_typed;
    bool m_open = false;
    int m_wrong = 0;
    double m_wait_s = 0.0;
    double m_untouched_s = 0.0;
};

}  // namespace sagara::ui
