package tellosimulator.conformance;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/**
 * Tests each link fault that affects a share of the datagrams, at 20 % in all directions: programs
 * that repeat failed commands fly ten commands with each client. All of them fly at once, each in
 * its own network, because they mostly wait.
 */
@NeedsTool(Tool.PYTHON)
class LinkFaultsIT {

  private static final List<String> CLIENTS = List.of("djitellopy", "tello-asyncio", "tellojs");

  private static final List<String> FAULTS =
      List.of("loss 20%", "duplicate 20%", "reorder 20%", "corrupt 20%");

  private final ExecutorService flights = Executors.newCachedThreadPool();

  @AfterEach
  void end() {
    flights.shutdownNow();
  }

  @Test
  void programsThatRepeatWhatFailedFlyTenCommands() throws Throwable {
    List<Future<?>> flying = new ArrayList<>();
    for (String client : CLIENTS) {
      for (String fault : FAULTS) {
        flying.add(
            flights.submit(
                () -> {
                  ClientFlight.fly("--private-network", client, "--fault", fault);
                  return null;
                }));
      }
    }
    for (Future<?> flight : flying) {
      try {
        flight.get();
      } catch (ExecutionException e) {
        throw e.getCause();
      }
    }
  }
}
