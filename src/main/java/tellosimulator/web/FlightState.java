package tellosimulator.web;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.model.DroneState;
import tellosimulator.scenario.Description;
import tellosimulator.sim.LastCommand;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.world.Wind;

/**
 * Describes the present state of a simulation as a map for {@code Json}, in centimetres, degrees
 * and seconds, for pages and for the teacher's board. Stateless.
 */
final class FlightState {

  private FlightState() {}

  static Map<String, Object> of(WebSubject subject, WebTexts texts) {
    SimSnapshot snapshot = subject.simulation().snapshot();
    Wind wind = snapshot.arena().wind();
    Description description = subject.opened().scenario().description();
    Locale locale = texts.translation().locale();
    return Json.object(
        "number", subject.number(),
        "title", description.name().in(locale),
        "teaches", description.teaches().in(locale),
        "time", Json.rounded(snapshot.time().seconds()),
        "paused", snapshot.clock().paused(),
        "factor", snapshot.clock().factor().toString(),
        "varies", subject.opened().varies(),
        "wind", Math.round(Frames.centimeters(wind.mean().norm())),
        "towards", Math.round(Math.toDegrees(Math.atan2(wind.mean().y(), wind.mean().x()))),
        "link", snapshot.drones().get(0).faults().link().option(),
        "goals", goals(subject.goals().progress(), texts),
        "last", subject.lastCommand().newest().map(shown -> command(shown, texts)),
        "drones", snapshot.drones().stream().map(drone -> drone(drone, texts)).toList());
  }

  private static Map<String, Object> goals(Progress progress, WebTexts texts) {
    Challenge challenge = progress.challenge();
    List<Map<String, Object>> tasks = new ArrayList<>();
    for (int i = 0; i < challenge.goals().size(); i++) {
      Goal goal = challenge.goals().get(i);
      tasks.add(
          Json.object(
              "task", texts.say(goal.task()),
              "state", progress.state(i).name().toLowerCase(Locale.ROOT),
              "drone", goal.drone().isPresent() ? goal.drone().getAsInt() : null));
    }
    return Json.object(
        "status", progress.status().name().toLowerCase(Locale.ROOT),
        "tasks", tasks,
        "reached", progress.count(),
        "clock", Json.rounded(progress.elapsed()),
        "limit", challenge.timeLimit().isPresent() ? challenge.timeLimit().getAsDouble() : null,
        "why", progress.failure().or(progress::miss).map(texts::say),
        "points", progress.score().map(Score::points),
        "of", progress.score().map(Score::of));
  }

  private static Map<String, Object> command(LastCommand.Shown shown, WebTexts texts) {
    return Json.object(
        "drone", shown.drone(),
        "text", shown.text(),
        "outcome", shown.outcome().name().toLowerCase(Locale.ROOT),
        "reply", shown.reply(),
        "reason", shown.reason().map(texts::say));
  }

  private static Map<String, Object> drone(DroneSnapshot drone, WebTexts texts) {
    DroneState state = drone.state();
    double heading = Frames.wrapped(state.motion().attitude().heading());
    String phase = state.phase().name().toLowerCase(Locale.ROOT).replace('_', '-');
    return Json.object(
        "drone", state.drone(),
        "phase", phase,
        "word", texts.text("controls.phase." + phase),
        "flying", state.phase().flying(),
        "height", Math.round(Frames.centimeters(state.motion().position().z())),
        "heading", Math.round(Frames.yawOfHeading(heading)) + 0,
        "battery", state.energy().battery().percent(),
        "operator", drone.link().operator().map(peer -> peer.host()),
        "faults", drone.faults().faults().stream().map(fault -> fault.text()).toList());
  }
}
