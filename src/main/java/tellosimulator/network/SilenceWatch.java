package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Detects that drones are on but receive nothing. The most common cause is a program that still
 * sends to port 8889. The simulator cannot listen on that port permanently, because operator
 * programs bind the port themselves and would fail to start. This class therefore only probes
 * whether the port is free. Not thread-safe.
 */
final class SilenceWatch {

  /**
   * Number of checks, one per second, for which a program may hold the port without sending.
   * Decided.
   */
  static final int LOOKS_WITH_PROGRAM = 8;

  /** Number of checks for which drones may be on without receiving anything. Decided. */
  static final int LOOKS = 45;

  private final InetSocketAddress operators;
  private final BooleanSupplier silent;
  private final Consumer<Silence> listener;
  private int looks;
  private int withProgram;
  private boolean told;

  /**
   * Creates a watch.
   *
   * @param operators the address where operator programs listen on this machine
   * @param silent whether drones are on and have never received anything
   * @param listener notified at most once, on the thread that calls {@link #look}
   */
  SilenceWatch(InetSocketAddress operators, BooleanSupplier silent, Consumer<Silence> listener) {
    this.operators = operators;
    this.silent = silent;
    this.listener = listener;
  }

  /** Performs one check. Must be called once per second. */
  void look() {
    if (told) {
      return;
    }
    boolean now = silent.getAsBoolean();
    looks = now ? looks + 1 : 0;
    withProgram = now && UdpPort.isTaken(operators) ? withProgram + 1 : 0;
    if (withProgram >= LOOKS_WITH_PROGRAM || looks >= LOOKS) {
      told = true;
      listener.accept(withProgram > 0 ? Silence.PROGRAM_ELSEWHERE : Silence.NOTHING_CAME);
    }
  }
}
