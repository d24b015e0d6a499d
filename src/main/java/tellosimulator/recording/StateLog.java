package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The state lines of a recording, which are all that is known of how a real drone moved. */
public final class StateLog {

  private StateLog() {}

  /**
   * Reads the state lines of a recording. Those that are damaged are left out.
   *
   * @return in the order in which they were sent; empty if none are kept
   * @throws IOException if they cannot be read
   */
  public static List<ReportedState> read(Path folder) throws IOException {
    List<ReportedState> states = new ArrayList<>();
    WireLog.read(
        folder,
        sent -> {
          if (sent.kind().equals("state")) {
            ReportedState.of(sent.time(), sent.drone(), sent.text()).ifPresent(states::add);
          }
        });
    return states;
  }
}
