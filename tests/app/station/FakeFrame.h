#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QStackedWidget>
#include <QTest>

#include "app/station/Frame.h"
#include "ui/theme/Theme.h"

namespace sagara::station {

/// A window with a stack of pages, as far as a door needs one.
class FakeFrame final : public Frame {
public:
    explicit FakeFrame(run::Store& store) : m_store(store) { m_stack.resize(1280, 720); }
    ~FakeFrame() override { dropPages(); }

    run::Store& store() override { return m_store; }
    render::Stage* stageFor(const std::shared_ptr<const core::World>& world) override {
        if (m_stage && m_staged != world && m_stage->show(world)) return nullptr;
        m_staged = world;
        return m_stage.get();
    }
    ui::PaletteName colours() const override { return m_colours; }
    void openPage(ui::Page* page) override {
        m_stack.addWidget(page);
        page->setColours(m_colours);
        m_stack.setCurrentWidget(page);
        m_stack.show();
    }
    void replacePage(ui::Page* page) override {
        QWidget* const gone = m_stack.currentWidget();
        m_stack.removeWidget(gone);
        gone->hide();
        gone->deleteLater();
        openPage(page);
    }
    std::optional<std::string> openRun(const RunRequest&) override { return "not here"; }
    std::optional<std::string> openDebrief(const std::filesystem::path& recording) override {
        debriefed.push_back(recording);
        return std::nullopt;
    }

    template <typename PageKind>
    PageKind* page() const {
        return qobject_cast<PageKind*>(m_stack.currentWidget());
    }
    /// As the window does when somebody goes back.
    void leave() {
        QWidget* const gone = m_stack.currentWidget();
        m_stack.removeWidget(gone);
        delete gone;
        m_stack.setCurrentIndex(m_stack.count() - 1);
    }
    void dropPages() {
        while (m_stack.count() > 0) leave();
    }
    QStackedWidget& stack() { return m_stack; }

    std::unique_ptr<render::Stage> m_stage;
    ui::PaletteName m_colours = ui::PaletteName::Day;
    std::vector<std::filesystem::path> debriefed;

private:
    run::Store& m_store;
    QStackedWidget m_stack;
    std::shared_ptr<const core::World> m_staged;
};

/// A data folder of its own and a FakeFrame on it.
class FakeStation : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() / ("sagara-door-" + std::to_string(::getpid()));
        std::filesystem::remove_all(m_folder);
        auto opened = run::Store::open(m_folder);
        ASSERT_TRUE(opened) << opened.error();
        m_store = std::move(opened).value();
        m_frame = std::make_unique<FakeFrame>(*m_store);
    }
    void TearDown() override {
        m_frame.reset();
        m_store.reset();
        std::filesystem::remove_all(m_folder);
    }

    FakeFrame& frame() { return *m_frame; }
    run::Store& store() { return *m_store; }
    QStackedWidget& window() { return m_frame->stack(); }
    void withStage() {
        auto stage = render::Stage::open({SAGARA_ASSETS, render::Preset::Medium, true});
        ASSERT_TRUE(stage) << stage.error();
        m_frame->m_stage = std::move(stage).value();
    }
    void setColours(ui::PaletteName palette) {
        m_frame->m_colours = palette;
        ui::applyTheme(*qApp, palette);
    }
    void keepPicture(const QString& name) {
        const QString folder = qEnvironmentVariable("SAGARA_UI_PICTURES");
        if (folder.isEmpty()) return;
        QApplication::processEvents();
        window().grab().save(folder + QLatin1Char('/') + name);
    }
    void keepPicture(const char* name) { keepPicture(QString::fromLatin1(name)); }

private:
    std::filesystem::path m_folder;
    std::unique_ptr<run::Store> m_store;
    std::unique_ptr<FakeFrame> m_frame;
};

}  // namespace sagara::station
