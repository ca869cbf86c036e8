#include "ui/demo/DemoLock.h"

#include <algorithm>
#include <cmath>

namespace sagara::ui {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

DemoLock::DemoLock(std::string pin) : m_pin(std::move(pin)) {
    const bool usable =
        !m_pin.empty() && m_pin.size() <= kMostDigits && std::all_of(m_pin.begin(), m_pin.end(), isDigit);
    if (!usable) m_pin = "0000";
}

void DemoLock::open() {
    m_open = true;
    m_typed.clear();
    m_untouched_s = 0.0;
}

void DemoLock::close() {
    m_open = false;
    m_typed.clear();
}

bool DemoLock::type(char digit) {
    if (!m_open || m_wait_s > 0.0 || !isDigit(digit)) return false;
    m_untouched_s = 0.0;
    m_typed.push_back(digit);
    if (m_typed.size() < m_pin.size()) return false;
    const bool right = m_typed == m_pin;
    m_typed.clear();
    if (right) {
        m_wrong = 0;
        return true;
    }
    m_wait_s = std::min(kLongestWait_s, kFirstWait_s * std::pow(2.0, m_wrong));
    ++m_wrong;
    return false;
}

void DemoLock::erase() {
    m_untouched_s = 0.0;
    if (!m_typed.empty()) m_typed.pop_back();
}

void DemoLock::advance(double elapsed_s) {
    m_wait_s = std::max(0.0, m_wait_s - elapsed_s);
    m_untouched_s += elapsed_s;
    if (m_open && m_wait_s == 0.0 && m_untouched_s >= kClosesAfter_s) close();
}

}  // namespace sagara::ui
