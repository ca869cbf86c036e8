#include "db/AssessmentRepository.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;

const Assessment kLenient{"Kept a good look-out.", Overrule{72.0, true, "The squall came out of season."}};

class Assessing : public ::testing::Test {
protected:
    Assessing() {
        NewRun run = lesson();
        run.person = m_trainee;
        m_run = fileRun(m_db, {run, ended(), good()});
    }
    std::string refusalOf(const QString& sql) {
        return errorOf([&] { execute(m_db.connection(), sql); }).what();
    }
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    PersonRepository m_people{m_db};
    PersonId m_trainee = *m_people.add("Perera", Role::Trainee, kMorning);
    PersonId m_trainer = *m_people.add("Silva", Role::Trainer, kMorning);
    AssessmentRepository m_assessments{m_db};
    RunId m_run{};
};

TEST_F(Assessing, ADraftMayBeChanged) {
    EXPECT_FALSE(m_assessments.find(m_run));
    ASSERT_TRUE(m_assessments.put(m_run, {"draft", {}}, kMorning));
    ASSERT_TRUE(m_assessments.put(m_run, kLenient, kNoon));
    const AssessmentRecord record = m_assessments.find(m_run).value();
    EXPECT_EQ(record.assessment, kLenient);
    EXPECT_EQ(record.changed, kNoon);
    EXPECT_FALSE(record.signedOff);
}

TEST_F(Assessing, OverrulingNeedsAReasonAndAScoreOfTheScale) {
    EXPECT_EQ(m_assessments.put(m_run, {"", Overrule{50.0, false, " \n"}}, kNoon).error(),
              AssessError::ReasonEmpty);
    EXPECT_EQ(m_assessments.put(m_run, {"", Overrule{100.5, true, "x"}}, kNoon).error(),
              AssessError::ScoreOutOfRange);
    EXPECT_EQ(m_assessments.put(m_run, {std::string(4001, 'x'), {}}, kNoon).error(),
              AssessError::CommentTooLong);
    EXPECT_FALSE(m_assessments.find(m_run));
    EXPECT_FALSE(toText(AssessError::ReasonEmpty).empty());
}

TEST_F(Assessing, AfterTheSignOffNothingChanges) {
    ASSERT_TRUE(m_assessments.put(m_run, kLenient, kMorning));
    const auto signOff = m_assessments.sign(m_run, m_trainer, kNoon);
    ASSERT_TRUE(signOff);
    EXPECT_EQ(*signOff, (SignOff{m_trainer, "Silva", kNoon}));
    EXPECT_EQ(m_assessments.put(m_run, {"other", {}}, kNoon).error(), AssessError::SignedAlready);
    EXPECT_EQ(m_assessments.sign(m_run, m_trainer, kNoon).error(), AssessError::SignedAlready);
    EXPECT_EQ(m_assessments.find(m_run)->assessment, kLenient);
    EXPECT_EQ(m_assessments.find(m_run)->signedOff, *signOff);
}

TEST_F(Assessing, TheSchemaItselfKeepsWhatWasSigned) {
    ASSERT_TRUE(m_assessments.sign(m_run, m_trainer, kNoon));
    EXPECT_NE(refusalOf(u"UPDATE assessment SET comment = 'forged'"_s).find("signed off"), std::string::npos);
    EXPECT_NE(refusalOf(u"DELETE FROM assessment"_s).find("signed off"), std::string::npos);
    EXPECT_NE(refusalOf(u"UPDATE grade SET score = 100"_s).find("signed off"), std::string::npos);
    EXPECT_NE(refusalOf(u"DELETE FROM grade"_s).find("signed off"), std::string::npos);
    EXPECT_THROW(GradeRepository(m_db).put(m_run, good()), DbError);
    EXPECT_TRUE(m_assessments.find(m_run)->signedOff);
}

TEST_F(Assessing, TheNameOfTheSignatureStaysWhenThePersonIsRenamed) {
    ASSERT_TRUE(m_assessments.sign(m_run, m_trainer, kNoon));
    NewPerson renamed;
    renamed.name = "Silva-Dias";
    renamed.role = Role::Trainer;
    ASSERT_TRUE(m_people.change(m_trainer, renamed));
    EXPECT_EQ(m_assessments.find(m_run)->signedOff->name, "Silva");
}

TEST_F(Assessing, OnlySomebodyElsesEndedRunIsSignedByATrainer) {
    EXPECT_EQ(m_assessments.sign(m_run, m_trainee, kNoon).error(), AssessError::NotATrainer);
    EXPECT_EQ(m_assessments.sign(m_run, PersonId{99}, kNoon).error(), AssessError::NotATrainer);
    EXPECT_EQ(m_assessments.sign(RunId{99}, m_trainer, kNoon).error(), AssessError::RunNotEnded);
    NewRun own = lesson("recordings/own");
    own.person = m_trainer;
    const RunId ownRun = RunRepository(m_db).start(own);
    EXPECT_EQ(m_assessments.sign(ownRun, m_trainer, kNoon).error(), AssessError::RunNotEnded);
    RunRepository(m_db).finish(ownRun, ended());
    EXPECT_EQ(m_assessments.sign(ownRun, m_trainer, kNoon).error(), AssessError::OwnRun);
    m_people.retire(m_trainer);
    EXPECT_EQ(m_assessments.sign(m_run, m_trainer, kNoon).error(), AssessError::NotATrainer);
}

TEST_F(Assessing, FilingASignedRunAgainChangesNothing) {
    ASSERT_TRUE(m_assessments.sign(m_run, m_trainer, kNoon));
    NewRun run = lesson();
    Grade other = good();
    other.score = 1.0;
    EXPECT_EQ(fileRun(m_db, {run, ended(), other}), m_run);
    EXPECT_EQ(GradeRepository(m_db).find(m_run), good());
}

}  // namespace
}  // namespace sagara::db
