package tellosimulator.fault;

import java.util.Optional;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.sensor.SensorReadings.Range;
import tellosimulator.sensor.TimeOfFlight;

/** Applies faults to sensor readings. */
public final class SensorFaults {

  private SensorFaults() {}

  /** Returns the readings with the errors caused by the active faults. */
  public static SensorReadings applied(SensorReadings readings, ActiveFaults faults) {
    if (faults.faults().isEmpty()) {
      return readings;
    }
    Optional<Fault> jump = faults.find(FaultKind.BARO_JUMP);
    double step = jump.map(fault -> fault.value(FaultParameter.STEP)).orElse(0.0);
    boolean noEcho = faults.find(FaultKind.TOF_OUT).isPresent();
    return new SensorReadings(
        readings.attitude(),
        readings.velocityDm(),
        noEcho ? new Range(TimeOfFlight.NONE_MM, readings.range().heightDm()) : readings.range(),
        readings.barometer() + step,
        readings.acceleration(),
        readings.health());
  }
}
