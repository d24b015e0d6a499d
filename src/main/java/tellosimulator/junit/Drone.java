package tellosimulator.junit;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Selects the drone that a parameter of type {@link SimulatedDrone} receives. Without this
 * annotation, the parameter receives the first drone.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.PARAMETER)
public @interface Drone {

  /** The number of the drone, from 1. */
  int value();
}
