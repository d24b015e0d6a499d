package tellosimulator.memory;

import com.sun.management.HotSpotDiagnosticMXBean;
import com.sun.management.VMOption;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.management.JMException;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.time.Ticker;

/**
 * Lets the Java machine give memory back that the program does not need, as far as a running one
 * can be told: a jar cannot say such options on its command line. What somebody has set there
 * stays. Measured: see docs/benchmarks.md. For its own thread.
 */
public final class ProcessMemory implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(ProcessMemory.class);

  /** Decided: late enough not to slow the start down, and so seldom that it costs nothing [ns]. */
  private static final long PERIOD_NANOS = 10_000_000_000L;

  /** An option of the Java machine that can be set while it runs. */
  private record Option(String name, String value) {}

  /**
   * The heap follows what is alive, after concurrent collections at least this often, which
   * interrupt for milliseconds. In this order, as the least ratio must not be above the largest.
   */
  private static final List<Option> OPTIONS =
      List.of(
          new Option("MinHeapFreeRatio", "10"), // [%]
          new Option("MaxHeapFreeRatio", "25"), // [%]
          new Option("G1PeriodicGCInterval", "10000")); // [ms]

  /** Whether the machine itself trims the C library's heap [ms]. Documented: JDK-8293114. */
  private static final String TRIMS_ITSELF = "TrimNativeHeapInterval";

  private static final ErrorPolicy FAILED =
      ErrorPolicy.finish("The memory of the process is not kept small any more");

  private final Supplier<Optional<HotSpotDiagnosticMXBean>> machine;

  private final Ticker ticker = new Ticker();

  private boolean begun;

  /**
   * @param machine is asked for late, as it takes time to be made; empty for another than HotSpot
   */
  ProcessMemory(Supplier<Optional<HotSpotDiagnosticMXBean>> machine) {
    this.machine = machine;
  }

  /** Begins, on a thread that does not keep the program alive. */
  public static void keepSmall() {
    Worker.start("process-memory", new ProcessMemory(ProcessMemory::machine));
  }

  private static Optional<HotSpotDiagnosticMXBean> machine() {
    return Optional.ofNullable(ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class));
  }

  @Override
  public Outcome doWork() throws JMException {
    if (!begun) {
      begun = true;
      return Outcome.IDLE;
    }
    Optional<HotSpotDiagnosticMXBean> found = machine.get();
    return found.isPresent() ? shrink(found.get()) : Outcome.FINISHED;
  }

  private static Outcome shrink(HotSpotDiagnosticMXBean machine) throws JMException {
    OPTIONS.forEach(option -> set(machine, option));
    boolean trimmed =
        option(machine, TRIMS_ITSELF).map(option -> option.getValue().equals("0")).orElse(true)
            && trimNativeHeap();
    return trimmed ? Outcome.IDLE : Outcome.FINISHED;
  }

  /** Sets an option, unless somebody has set it, there is none, or it contradicts what is set. */
  private static void set(HotSpotDiagnosticMXBean machine, Option wanted) {
    Optional<VMOption> option = option(machine, wanted.name());
    if (option.filter(o -> o.getOrigin() == VMOption.Origin.DEFAULT).isEmpty()) {
      return;
    }
    try {
      machine.setVMOption(wanted.name(), wanted.value());
    } catch (IllegalArgumentException e) {
      LOG.debug("{} stays {}", wanted.name(), option.get().getValue(), e);
    }
  }

  private static Optional<VMOption> option(HotSpotDiagnosticMXBean machine, String name) {
    try {
      return Optional.of(machine.getVMOption(name));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Whether the C library could give memory back that it keeps for later, as glibc can. */
  private static boolean trimNativeHeap() throws JMException {
    MBeanServer server = ManagementFactory.getPlatformMBeanServer();
    ObjectName commands = new ObjectName("com.sun.management:type=DiagnosticCommand");
    String trim = "systemTrimNativeHeap";
    for (var operation : server.getMBeanInfo(commands).getOperations()) {
      if (operation.getName().equals(trim)) {
        server.invoke(commands, trim, new Object[0], new String[0]);
        return true;
      }
    }
    return false;
  }

  @Override
  public void idle() {
    ticker.pauseUntil(ticker.nanos() + PERIOD_NANOS);
  }

  @Override
  public ErrorPolicy onError(Throwable failure) {
    return FAILED;
  }
}
