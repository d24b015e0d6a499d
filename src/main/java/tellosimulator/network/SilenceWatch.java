package tellosimulator.network;

import java.net.InetSocketAddress;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Notices once that nothing comes to drones that are on, because a program sends elsewhere: the
 * most common mistake is to keep port 8889. Nobody can listen there for long, since operator
 * programs bind that port themselves and would not start; so this only tries for a moment whether
 * the port is free. For one thread.
 */
final class SilenceWatch {

  /** Looks, one a second, for which a program may have the port and say nothing. Decided. */
  static final int LOOKS_WITH_PROGRAM = 8;

  /** Looks for which drones may be on and hear nothing at all. Decided. */
  static final int LOOKS = 45;

  private final InetSocketAddress operators;
  private final BooleanSupplier silent;
  private final Consumer<Silence> listener;
  private int looks;
  private int withProgram;
  private boolean told;

  /**
   * @param operators where operator programs listen on this machine
   * @param silent whether drones are on and nothing has ever come to them
   * @param listener is told at most once, on the thread that looks
   */
  SilenceWatch(InetSocketAddress operators, BooleanSupplier silent, Consumer<Silence> listener) {
    this.operators = operators;
    this.silent = silent;
    this.listener = listener;
  }

  /** Looks once more; to be called once a second. */
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
