package tellosimulator.conformance;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;

/**
 * Each fault of the link that concerns a share of the datagrams, at 20 % in all directions:
 * programs that repeat what failed fly ten commands with each client. All clients fly at once, each
 * in a network of its own, because they mostly wait.
 */
@NeedsTool(Tool.PYTHON)
class LinkFaultsIT {

  private static final List<String> CLIENTS = List.of("djitellopy", "tello-asyncio", "tellojs");

  private static final List<String> FAULTS =
      List.of("loss 20%", "duplicate 20%", "reorder 20%", "corrupt 20%");

  private final ExecutorService flights = Executors.newFixedThreadPool(CLIENTS.size());

  @AfterEach
  void end() {
    flights.shutdownNow();
  }

  @Test
  void programsThatRepeatWhatFailedFlyTenCommands() throws Throwable {
    List<Future<?>> flying = new ArrayList<>();
    for (String client : CLIENTS) {
      flying.add(
          flights.submit(
              () -> {
                ClientFlight.fly(arguments(client));
                return null;
              }));
    }
    for (Future<?> flight : flying) {
      try {
        flight.get();
      } catch (ExecutionException e) {
        throw e.getCause();
      }
    }
  }

  private static String[] arguments(String client) {
    Stream<String> faults = FAULTS.stream().flatMap(fault -> Stream.of("--fault", fault));
    return Stream.concat(Stream.of("--private-network", client), faults).toArray(String[]::new);
  }
}
