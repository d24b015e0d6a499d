package tellosimulator.video.camera;

import tellosimulator.math.Pose;
import tellosimulator.scenery.Scene;

/**
 * Everything that a frame shows, besides its size and the camera's optics: equal ones give equal
 * frames. Immutable; for any thread.
 *
 * @param scene what the camera sees
 * @param drone pose of the drone that carries the camera, room frame
 * @param downward whether it is the camera that looks at the floor
 */
public record CameraView(Scene scene, Pose drone, boolean downward) {}
