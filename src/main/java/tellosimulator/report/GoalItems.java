package tellosimulator.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.Progress;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.MarkColors;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;

/**
 * Where the goals of a flight are, as the page's plan has them, in cm and degrees clockwise; how
 * one stands with them follows from the moment that the page shows. Immutable.
 */
final class GoalItems {

  private final RecordedFlight flight;
  private final Challenge challenge;
  private final List<GoalMark> marks;
  private final ReportTexts texts;

  GoalItems(RecordedFlight flight, Arena arena, ReportTexts texts) {
    this.flight = flight;
    this.texts = texts;
    challenge = flight.scenario().map(Scenario::challenge).orElse(Challenge.NONE);
    List<OptionalDouble> none =
        challenge.goals().stream().map(goal -> OptionalDouble.empty()).toList();
    marks = GoalMark.of(new Progress(challenge, none, 0, Optional.empty()), arena);
  }

  Map<String, Object> members() {
    Map<String, Object> colors = new LinkedHashMap<>();
    for (GoalState state : GoalState.values()) {
      colors.put(state.name().toLowerCase(Locale.ROOT), hex(MarkColors.of(state)));
    }
    colors.put("contact", hex(MarkColors.CONTACT));
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("goalPlaces", marks.stream().map(this::place).toList());
    members.put("goalsInOrder", challenge.inOrder());
    members.put("markColors", colors);
    return members;
  }

  private static String hex(Rgb color) {
    return String.format(Locale.ROOT, "#%06x", color.argb() & 0xffffff);
  }

  private Map<String, Object> place(GoalMark mark) {
    Vec3 middle = mark.place().middle();
    Map<String, Object> item = new LinkedHashMap<>();
    item.put("number", mark.number());
    mark.drone().ifPresent(drone -> item.put("drone", drone));
    reached(mark.number()).ifPresent(time -> item.put("reached", Json.rounded(time)));
    item.put("label", texts.say(challenge.goals().get(mark.number() - 1).phrase()));
    item.put("x", cm(middle.x()));
    item.put("y", cm(middle.y()));
    if (mark.place() instanceof GoalMark.Ball ball) {
      item.put("radius", cm(ball.radius()));
    } else if (mark.place() instanceof GoalMark.Circle circle) {
      item.put("radius", cm(circle.radius()));
      item.put("landing", true);
    } else if (mark.place() instanceof GoalMark.Opening opening) {
      double heading = opening.pose().attitude().heading();
      item.put("width", cm(Footprint.size(opening.gate()).y()));
      item.put("heading", Json.rounded(Frames.yawOfHeading(heading)));
      item.put("way", opening.direction().name().toLowerCase(Locale.ROOT));
    }
    return item;
  }

  /** When it was reached [simulated s]; a recording that was cut off does not say it. */
  private OptionalDouble reached(int number) {
    return number <= flight.goals().size()
        ? flight.goals().get(number - 1).reached()
        : OptionalDouble.empty();
  }

  private static double cm(double meters) {
    return Json.rounded(Frames.centimeters(meters));
  }
}
