package tellosimulator.video.camera;

import tellosimulator.math.Pose;
import tellosimulator.scenery.Scene;

/**
 * Everything that determines a frame, except its size and the camera's optics. Equal views result
 * in frames that are equal except for the sensor's noise. Immutable.
 *
 * @param scene the objects in front of the camera
 * @param drone the pose of the drone that carries the camera, in the room frame
 * @param downward whether this is the view of the downward camera rather than of the forward camera
 */
public record CameraView(Scene scene, Pose drone, boolean downward) {}
