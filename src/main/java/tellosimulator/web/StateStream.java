package tellosimulator.web;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import tellosimulator.goal.Progress;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.Ticker;

/** Sends the state of the simulation as server-sent events, ten times a second if it changes. */
final class StateStream {

  /** Time between two events [ns]. Decided: as often as the drone's own state lines. */
  private static final long PERIOD = 100_000_000;

  private final WebSubject subject;

  StateStream(WebSubject subject) {
    this.subject = subject;
  }

  /** Sends events until the browser goes away, or the stream ends. Blocks. */
  void send(HttpExchange request, BooleanSupplier open) throws IOException {
    request.getResponseHeaders().set("Content-Type", "text/event-stream");
    request.sendResponseHeaders(200, 0);
    OutputStream out = request.getResponseBody();
    Ticker ticker = new Ticker();
    String before = "";
    while (open.getAsBoolean()) {
      if (ticker.awaitTick(PERIOD)) {
        String state = Json.text(state());
        if (!state.equals(before)) {
          out.write(("data: " + state + "\n\n").getBytes(StandardCharsets.UTF_8));
          out.flush();
          before = state;
        }
      }
    }
  }

  private Map<String, Object> state() {
    SimSnapshot snapshot = subject.simulation().snapshot();
    Progress progress = subject.goals().progress();
    List<Map<String, Object>> drones = snapshot.drones().stream().map(StateStream::drone).toList();
    return Json.object(
        "time", Json.rounded(snapshot.time().seconds()),
        "paused", snapshot.clock().paused(),
        "goals", progress.phrase().english(),
        "drones", drones);
  }

  private static Map<String, Object> drone(DroneSnapshot drone) {
    DroneState state = drone.state();
    return Json.object(
        "drone", state.drone(),
        "phase", state.phase().words(),
        "height", Json.rounded(Frames.centimeters(state.motion().position().z())),
        "heading",
            Json.rounded(Frames.yawOfHeading(Frames.wrapped(state.motion().attitude().heading()))),
        "battery", state.energy().battery().percent());
  }
}
