package tellosimulator.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.PlacedGoal.PlaceCases;
import tellosimulator.goal.Progress;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.OverlayColors;
import tellosimulator.world.Arena;

/**
 * Converts the goals of a flight to members of the page's plan, in cm and degrees clockwise. The
 * page itself determines the status of each goal at the time that the user has selected. Immutable.
 */
final class GoalItems {

  private final RecordedFlight flight;
  private final Challenge challenge;
  private final List<PlacedGoal> marks;
  private final ReportTexts texts;

  GoalItems(RecordedFlight flight, Arena arena, ReportTexts texts) {
    this.flight = flight;
    this.texts = texts;
    challenge = flight.scenario().map(Scenario::challenge).orElse(Challenge.NONE);
    marks = PlacedGoal.of(Progress.start(challenge), arena);
  }

  Map<String, Object> members() {
    Map<String, Object> colors = new LinkedHashMap<>();
    for (GoalState state : GoalState.values()) {
      colors.put(state.name().toLowerCase(Locale.ROOT), hex(OverlayColors.of(state)));
    }
    colors.put("contact", hex(OverlayColors.CONTACT));
    return Json.object(
        "goalPlaces", marks.stream().map(this::place).toList(),
        "goalsInOrder", challenge.inOrder(),
        "markColors", colors);
  }

  private static String hex(Rgb color) {
    return String.format(Locale.ROOT, "#%06x", color.argb() & 0xffffff);
  }

  private Map<String, Object> place(PlacedGoal mark) {
    Vec3 middle = mark.place().middle();
    Map<String, Object> item =
        Json.object(
            "number", mark.number(),
            "drone", mark.drone(),
            "reached", reached(mark.number()),
            "label", texts.say(challenge.goals().get(mark.number() - 1).phrase()),
            "x", Frames.centimeters(middle.x()),
            "y", Frames.centimeters(middle.y()));
    item.putAll(
        mark.place()
            .match(
                new PlaceCases<>(
                    ball -> Json.object("radius", Frames.centimeters(ball.radius())),
                    circle ->
                        Json.object("radius", Frames.centimeters(circle.radius()), "landing", true),
                    GoalItems::opening,
                    square -> Json.object("radius", Frames.centimeters(square.edge() / 2)))));
    return item;
  }

  private static Map<String, Object> opening(PlacedGoal.Opening opening) {
    double heading = opening.pose().attitude().heading();
    return Json.object(
        "width", Frames.centimeters(opening.gate().size().y()),
        "heading", Frames.yawOfHeading(heading),
        "way", opening.direction().name().toLowerCase(Locale.ROOT));
  }

  /**
   * Returns the time at which a goal was reached [simulated s]; empty if it was not reached, or if
   * the recording was cut off.
   */
  private OptionalDouble reached(int number) {
    return number <= flight.goals().size()
        ? flight.goals().get(number - 1).reached()
        : OptionalDouble.empty();
  }
}
