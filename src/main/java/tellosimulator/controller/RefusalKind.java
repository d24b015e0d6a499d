package tellosimulator.controller;

/**
 * The reason why a drone does not carry out an order, or does not complete it. Each protocol has
 * its own reply for each kind.
 */
public enum RefusalKind {

  /** No more specific kind applies. */
  GENERAL,

  /** Another order is still being carried out. */
  BUSY,

  /** The motors are not running. */
  MOTORS_OFF,

  /** The drone does not know its position. */
  POSITION_UNKNOWN,

  /** The drone is too hot to take off. */
  OVERHEATED,

  /** A landing prevents or interrupts the order. */
  LANDING,

  /** The mission pad is not in view. */
  PAD_NOT_SEEN,

  /** The mission pad went out of view for too long. */
  PAD_LOST,

  /** The three points do not lie on a circle of an allowed radius. */
  RADIUS
}
