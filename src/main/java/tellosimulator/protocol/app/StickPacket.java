package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import tellosimulator.controller.Sticks;

/**
 * The payload of a stick packet: four sticks of 11 bits each, and the fast mode. The time that
 * follows is ignored, because clients send different things there.
 */
final class StickPacket {

  /** Length of the sticks [bytes]. Clients send 6, 11 or 16 bytes. */
  private static final int LENGTH = 6;

  private static final int BITS = 11;
  private static final int MASK = (1 << BITS) - 1;
  private static final int MIDDLE = 1024;

  /**
   * Distance from the middle to a full stick. Measured: TelloPy, gobot, TelloLib, SMerrony/tello.
   */
  private static final double FULL = 660;

  /** A full stick as {@code rc} knows it. Decided: {@code rc} moves the same sticks. */
  private static final double RC = 100;

  private static final int FAST_BIT = 44;

  /** Factor of the speeds in fast mode. Decided: no speed is published. */
  private static final double FAST = 2.5;

  private StickPacket() {}

  /** Returns the sticks in a payload; empty if it is too short. */
  static Optional<Sticks> parse(byte[] payload) {
    if (payload.length < LENGTH) {
      return Optional.empty();
    }
    ByteBuffer in = ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN);
    long bits = Integer.toUnsignedLong(in.getInt()) | (long) in.getShort() << Integer.SIZE;
    double factor = ((bits >> FAST_BIT) & 1) == 1 ? FAST : 1;
    return Optional.of(
        new Sticks(
            factor * stick(bits, 0),
            factor * stick(bits, 1),
            factor * stick(bits, 2),
            stick(bits, 3)));
  }

  private static double stick(long bits, int number) {
    double value = (((bits >> (BITS * number)) & MASK) - MIDDLE) * RC / FULL;
    return Math.max(-RC, Math.min(RC, value));
  }
}
