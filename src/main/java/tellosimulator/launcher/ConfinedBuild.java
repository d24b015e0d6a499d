package tellosimulator.launcher;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import tellosimulator.concurrent.Worker;

/**
 * Builds a program from its files, confined as the program itself is, in a network without any
 * drone. Works on the calling thread.
 */
public final class ConfinedBuild {

  /** Interval at which the limits are checked [ms]. Decided. */
  private static final long LOOK_MS = 50;

  /** Starts a command whose output is not that of the archive, and then packs its folder. */
  private static final List<String> PACKING =
      List.of("sh", "-c", "\"$@\" >&2 && exec tar -cf - .", "build");

  private final BooleanSupplier closed;

  /**
   * Creates a build without starting it.
   *
   * @param closed whether the build must end; is called on the thread of {@link #run}
   */
  public ConfinedBuild(BooleanSupplier closed) {
    this.closed = closed;
  }

  /**
   * Runs a build command.
   *
   * @param archive receives the built folder, as a tar archive
   * @param output receives what the command prints
   * @return the exit code; empty if a limit was exceeded
   * @throws UnavailableException if this system does not permit a private network
   * @throws IOException if the command cannot be started
   * @throws InterruptedException if the build had to end
   */
  public Optional<Integer> run(
      Confinement confinement, List<String> command, Path archive, Path output)
      throws UnavailableException, IOException, InterruptedException {
    int largest = Math.multiplyExact(confinement.limits().diskMb(), 1 << 20);
    try (OperatorNetwork network = OperatorNetwork.create(1);
        OutputStream file = Files.newOutputStream(output)) {
      ProcessBuilder builder =
          new ProcessBuilder(network.started(confinement.wrapped(PACKING, command)));
      confinement.prepare(builder, true);
      Process building = builder.start();
      InputStream said = building.getErrorStream();
      BoundedCopy copy = new BoundedCopy(said, file, confinement.limits().outputBytes());
      LimitWatch watch = new LimitWatch(confinement.limits());
      try (OutputStream packed = Files.newOutputStream(archive);
          Worker printing = Worker.start("build-output", copy);
          Worker keeping =
              Worker.start(
                  "build-archive", new BoundedCopy(building.getInputStream(), packed, largest))) {
        boolean ended = false;
        while (!ended
            && !closed.getAsBoolean()
            && watch.exceeded(building, copy.printed()).isEmpty()) {
          ended = building.waitFor(LOOK_MS, TimeUnit.MILLISECONDS);
        }
        if (!ended) {
          List<ProcessHandle> first = building.children().toList();
          building.destroyForcibly();
          first.forEach(ProcessHandle::destroyForcibly);
        }
        int code = building.waitFor();
        printing.end();
        keeping.end();
        if (closed.getAsBoolean()) {
          throw new InterruptedException();
        }
        return ended ? Optional.of(code) : Optional.empty();
      }
    }
  }
}
