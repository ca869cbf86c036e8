#pragma once

#include <X11/Xlib.h>
#undef None  // a macro of Xlib, and a name in our own headers

#include <string>
#include <vector>

namespace sagara::test {

/// A second client of the X server the tests run under: looks at windows and does to them what people do.
class XServer {
public:
    XServer();
    ~XServer();

    /// Two monitors side by side, each half of the screen.
    void splitInTwo();
    /// The window of that title, or 0.
    Window find(const std::string& title) const;
    struct Geometry {
        int left, top, width, height;
        friend bool operator==(const Geometry&, const Geometry&) = default;
    };
    Geometry geometry(Window window) const;
    void resize(Window window, int width, int height) const;
    void askToClose(Window window) const;
    /// Blue, green, red of every pixel from the top left.
    std::vector<unsigned char> pixels(Window window) const;
    int screenWidth() const;
    int screenHeight() const;

private:
    Display* m_display;
};

}  // namespace sagara::test
