package tellosimulator.goal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Scoring.Bonus;
import tellosimulator.goal.Scoring.Limits;
import tellosimulator.goal.Scoring.Par;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SimulatedDrones;

class ScoreTest {

  private static final Goal FRONT =
      new Goal.Reach(Terms.ANY.worth(10), new GoalRegion(new Vec3(1, 0, 0.3), 0.1));
  private static final Goal HOME =
      new Goal.Land(Terms.ANY.worth(2.5), new GoalRegion(Vec3.ZERO, 0.1));

  private static final Map<Infraction, Double> PENALTIES =
      Map.of(
          Infraction.TOUCH, 5.0,
          Infraction.CRASH, 20.0,
          Infraction.REFUSED, 1.0,
          Infraction.NOT_LANDED, 3.0);

  private static final Limits FREE = new Limits(-1000, Double.POSITIVE_INFINITY);

  private final List<SimEvent> news = new ArrayList<>();
  private GoalWatch watch;
  private SimulatedDrones drones;

  private void begin(Optional<Scoring> scoring, Goal... goals) {
    Challenge challenge =
        new Challenge(List.of(goals), false, OptionalDouble.empty(), false, scoring);
    watch = new GoalWatch(challenge, news::add);
    drones = new SimulatedDrones(SimConfig.DEFAULT, List.of(watch));
  }

  private void begin(Scoring scoring, Goal... goals) {
    begin(Optional.of(scoring), goals);
  }

  private static Scoring penalties(Limits limits) {
    return new Scoring(PENALTIES, Optional.empty(), Optional.empty(), limits);
  }

  private Score score() {
    return watch.progress().score().orElseThrow();
  }

  private List<String> entries() {
    return score().entries().stream()
        .map(entry -> Score.number(entry.points()) + " " + entry.why())
        .toList();
  }

  @Test
  void goalsHavePoints() {
    begin(Optional.empty(), FRONT, HOME);
    assertThat(score().phrase().english()).isEqualTo("score: 0 of 12.5 points");

    drones.fly("command", "takeoff", "forward 100", "back 100", "land");

    assertThat(entries())
        .containsExactly(
            "10 reached goal 1 of 2: reach x 100, y 0, z 30 cm",
            "2.5 reached goal 2 of 2: land at x 0, y 0 cm");
    assertThat(score().points()).isEqualTo(12.5);
    assertThat(score().entries().get(1).second()).isEqualTo(watch.progress().elapsed());
    assertThat(news).extracting(SimEvent::words).first().asString().endsWith("cm (10 points)");
    assertThat(news)
        .extracting(SimEvent::words)
        .last()
        .asString()
        .endsWith("; score: 12.5 of 12.5 points");
    assertThat(watch.tally().winners()).containsExactly(OptionalInt.of(1), OptionalInt.of(1));
  }

  @Test
  void withoutPointsThereIsNoScoreButATally() {
    Goal plain = HOME.withTerms(Terms.ANY);
    begin(Optional.empty(), plain);
    drones.fly("command", "takeoff", "forward 5000", "land");

    assertThat(watch.progress().score()).isEmpty();
    assertThat(watch.tally().commands()).isEqualTo(4);
    assertThat(watch.tally().count(Infraction.REFUSED)).isEqualTo(1);
    assertThat(news).extracting(SimEvent::words).noneMatch(words -> words.contains("point"));
  }

  @Test
  void mistakesCostPoints() {
    begin(penalties(FREE), FRONT, HOME);
    drones.fly("command", "flip x", "takeoff", "speed 20", "forward 260");

    assertThat(entries().get(0)).startsWith("-1 drone 1 refused `flip x`: ");
    assertThat(score().entries().get(0).second()).as("before the takeoff").isZero();
    assertThat(entries()).anyMatch(entry -> entry.equals("-5 drone 1 touched the front wall"));
    assertThat(watch.tally().count(Infraction.TOUCH)).isEqualTo(1);
    assertThat(news)
        .extracting(SimEvent::words)
        .contains("5 points lost: drone 1 touched the front wall");
  }

  @Test
  void aCrashCostsItsPointsOnly() {
    begin(penalties(FREE), FRONT, HOME);
    drones.fly("command", "takeoff", "up 150");
    drones.send(1, "emergency");
    drones.advance(3);

    assertThat(entries()).containsExactly("-20 drone 1 crashed into the floor");
    assertThat(score().points()).isEqualTo(-20);
    assertThat(score().of()).isEqualTo(12.5);
    assertThat(news)
        .extracting(SimEvent::words)
        .last()
        .asString()
        .endsWith(": drone 1 crashed into the floor; score: -20 of 12.5 points");
  }

  @Test
  void aTotalStaysWithinItsLimits() {
    begin(penalties(Limits.DEFAULT), FRONT, HOME);
    drones.fly("command", "takeoff", "up 150");
    drones.send(1, "emergency");
    drones.advance(3);
    assertThat(score().points()).isZero();

    begin(penalties(new Limits(-5, 8)), FRONT);
    assertThat(score().of()).isEqualTo(8);
    drones.fly("command", "takeoff", "forward 100");
    assertThat(score().points()).isEqualTo(8);
  }

  @Test
  void aDroneThatLandsByItselfCostsPoints() {
    begin(penalties(FREE), FRONT, HOME);
    drones.fly("command", "takeoff");
    drones.advance(25);

    assertThat(entries())
        .containsExactly(
            "-3 drone 1 lands by itself: no command came for 15 s",
            "2.5 reached goal 2 of 2: land at x 0, y 0 cm");
  }

  @Test
  void aSafetyLandingThatIsEndedByACommandCostsNothing() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff", "up 200");
    drones.advance(16);
    drones.fly("forward 20", "land");

    assertThat(entries()).isEmpty();
  }

  @Test
  void mistakesCountAfterTheVerdictUntilTheLanding() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff", "forward 100");
    assertThat(watch.progress().status()).isEqualTo(Status.REACHED);
    drones.fly("forward 5000");
    assertThat(score().points()).isEqualTo(9);

    drones.fly("land");
    drones.advance(1);
    drones.fly("forward 5000", "takeoff");
    drones.advance(25);
    assertThat(score().points()).as("its own command has landed it").isEqualTo(9);
  }

  @Test
  void aDroneThatStaysInTheAirAfterTheVerdictCostsPoints() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff", "forward 100");
    drones.advance(25);
    assertThat(score().points()).isEqualTo(7);

    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff");
    watch.close();
    watch.close();
    assertThat(entries()).containsExactly("-3 drone 1 was still in the air at the end");
  }

  @Test
  void whoIsSwitchedOffInFlightHasNotLanded() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff");
    drones.control(new Control.Power(1, false));
    drones.advance(1);

    assertThat(entries()).contains("-3 drone 1 was switched off in flight");
  }

  @Test
  void commandsOnTheGroundAfterTheLandingCostNothing() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff", "land");
    drones.advance(1);
    drones.fly("forward 5000");

    assertThat(entries()).isEmpty();
    assertThat(watch.tally().count(Infraction.REFUSED)).isZero();
  }

  @Test
  void theTimeInTheAirAfterParCostsPoints() {
    Scoring slow = new Scoring(Map.of(), Optional.of(new Par(5, 0.5)), Optional.empty(), FREE);
    begin(slow, FRONT, HOME);
    drones.fly("command", "takeoff", "forward 100", "back 100", "land");
    double late = watch.progress().elapsed() - 5;
    assertThat(late).isPositive();

    assertThat(score().points()).isCloseTo(12.5 - late / 2, within(0.01));
    assertThat(entries()).last().asString().endsWith(" s over par (5.0 s)");

    begin(slow, FRONT);
    drones.fly("command", "takeoff", "up 20", "down 20", "land");
    double landed = score().points();
    drones.advance(10);
    assertThat(score().points()).as("waiting on the ground").isEqualTo(landed).isNegative();
  }

  @Test
  void aBonusDecreasesWithTime() {
    Bonus bonus = new Bonus(10, 40, 80);
    assertThat(bonus.after(39)).isEqualTo(10);
    assertThat(bonus.after(40)).isEqualTo(10);
    assertThat(bonus.after(70)).as("a quarter of the time is left").isEqualTo(2.5);
    assertThat(bonus.after(81)).isZero();
  }

  @Test
  void onlyWhoReachesAllGoalsGetsTheBonus() {
    Bonus bonus = new Bonus(10, 40, 80);
    begin(new Scoring(PENALTIES, Optional.empty(), Optional.of(bonus), FREE), FRONT, HOME);
    assertThat(score().of()).isEqualTo(22.5);
    drones.fly("command", "takeoff", "forward 100");
    assertThat(score().points()).isEqualTo(10);

    drones.fly("back 100", "land");
    assertThat(score().points()).isEqualTo(22.5);
    assertThat(watch.progress().penaltiesAndBonus())
        .singleElement()
        .extracting(Score.Entry::points)
        .isEqualTo(10.0);
  }

  @Test
  void anAttemptThatHasEndedReachesNothing() {
    begin(penalties(FREE), FRONT, HOME);
    drones.fly("command", "takeoff");
    drones.control(new Control.EndAttempt());
    drones.fly("forward 100", "back 100", "land");

    assertThat(watch.progress().status()).isEqualTo(Status.RUNNING);
    assertThat(watch.progress().count()).isZero();
    assertThat(entries()).isEmpty();
  }

  @Test
  void aResetBeginsAgain() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff", "forward 5000");
    assertThat(score().points()).isEqualTo(-1);
    drones.control(new Control.Reset(1));

    assertThat(score()).isEqualTo(new Score(List.of(), 0, 10));
    assertThat(watch.tally().commands()).isZero();
  }

  @Test
  void aFloodOfRefusedCommandsHasFewEntries() {
    begin(penalties(FREE), FRONT);
    drones.fly("command", "takeoff");
    for (int i = 0; i < 250; i++) {
      drones.fly("forward 5000");
    }

    assertThat(score().entries()).hasSize(101);
    assertThat(entries()).last().isEqualTo("-150 150 further penalties");
    assertThat(score().points()).isEqualTo(-250);
  }

  @Test
  void pointsAreShownWithTheDecimalsThatTheyHave() {
    assertThat(Score.points(1).english()).isEqualTo("1 point");
    assertThat(Score.points(0).english()).isEqualTo("0 points");
    assertThat(Score.points(2.5).english()).isEqualTo("2.5 points");
    assertThat(Score.points(-0.125).english()).isEqualTo("-0.12 points");
  }
}
