package tellosimulator.jvm;

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
 * Makes the JVM return unused memory to the operating system. It can use only the JVM options that
 * can be set at run time, because a jar cannot put options on the JVM's command line. Options set
 * by the user are left unchanged. Measured (docs/benchmarks.md): after ten minutes of flight with
 * video, resident memory is 112 to 123 MB instead of 184 to 200 MB. Runs on its own thread.
 */
public final class ProcessMemory implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(ProcessMemory.class);

  /**
   * Time before the agent first acts, and between two of its actions [ns]. Decided: late enough not
   * to slow down the start of the program, and so rare that the cost is negligible.
   */
  private static final long PERIOD_NANOS = 10_000_000_000L;

  /** An option of the JVM that can be set at run time. */
  private record Option(String name, String value) {}

  /**
   * Options that make the size of the heap follow the amount of live data. They also cause a
   * concurrent collection at least every 10 s, with pauses of milliseconds. The order matters,
   * because the minimum ratio must not exceed the maximum.
   */
  private static final List<Option> OPTIONS =
      List.of(
          new Option("MinHeapFreeRatio", "10"), // [%]
          new Option("MaxHeapFreeRatio", "25"), // [%]
          new Option("G1PeriodicGCInterval", "10000")); // [ms]

  /**
   * JVM option for the interval at which the JVM itself trims the C library's heap [ms]; 0 if it
   * never does. Documented: JDK-8293114.
   */
  private static final String TRIMS_ITSELF = "TrimNativeHeapInterval";

  private static final ErrorPolicy FAILED =
      ErrorPolicy.finish("The memory of the process is not kept small any more");

  private final Supplier<Optional<HotSpotDiagnosticMXBean>> machine;

  private final Ticker ticker = new Ticker();

  private boolean begun;

  /**
   * Creates the agent.
   *
   * @param machine supplies access to the JVM's options, or empty for JVMs other than HotSpot; not
   *     called before the agent first acts, because creating the access takes time
   */
  ProcessMemory(Supplier<Optional<HotSpotDiagnosticMXBean>> machine) {
    this.machine = machine;
  }

  /** Starts the agent on a thread that does not keep the program alive. */
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

  /**
   * Sets an option, unless the user has set it, the JVM lacks it, or the value contradicts another
   * option.
   */
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

  /** Trims the C library's heap. Returns whether the library supports trimming, as glibc does. */
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
