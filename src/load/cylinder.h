#ifndef WF_LOAD_CYLINDER_H
#define WF_LOAD_CYLINDER_H
/* Drag coefficient of a long circular cylinder with bark in cross-flow as a function of Reynolds number.
 *
 * Below Re = 1e5 roughness does not raise the drag, and the law is that of the smooth cylinder: measurements
 * of Wieselsberger (1921, Neuere Feststellungen ueber die Gesetze des Fluessigkeits- und Luftwiderstands,
 * Phys. Z. 22:321-328) as drawn by Hoerner (1965, Fluid-Dynamic Drag, ch. 3) and Schlichting (1979,
 * Boundary-Layer Theory, fig. 1.4), the low end checked by Lamb's formula (58 at Re = 0.1) and Tritton (1959,
 * J. Fluid Mech. 6:547-567). Read off at 1, 2 and 5 of every decade; the experiments scatter by 5 to 10 %.
 *
 * Above, a smooth cylinder falls to 0.3 at Re = 5e5 (the drag crisis) and comes back to 0.7 at 3.5e6 (Roshko
 * 1961, J. Fluid Mech. 10:345-356). A rough one has its crisis earlier and shallower, and its drag is back
 * near 1 from a few 1e5 on (Achenbach 1971, Influence of surface roughness on the cross-flow around a
 * circular cylinder, J. Fluid Mech. 46:321-335; measurements collected in ESDU 80025). Of bark, the furrows
 * are some hundredths of the diameter deep. There the rules of practice say: 1.05 for a roughness of 0.01
 * diameters and more (DNV-RP-C205, 2010, section 6.7); 1.02 to 1.15 for 0.01 to 0.05 at Re = 1e6 (EN
 * 1991-1-4:2005, figure 7.28). The law goes from 1.2 at 1e5 to 1.05 at 5e5 and stays.
 *
 * It keeps to the upper side, because a stem that breaks unforeseen is worse than one thought
 * weaker than it is: the shallow dip of rough cylinders between 5e4 and 5e5 (to 0.6 .. 0.9, wherever
 * roughness and gustiness of the air put it) is left out. Trunks with bark were measured there below the
 * smooth cylinder (Tanaka et al. 2011, Int. J. River Basin Manag., doi:10.1080/15715124.2011.606427). Above
 * 5e4 expect the true coefficient within 0.6 and 1.2; of a smooth culm or young stem it may be as low as 0.3.
 * Who knows it writes drag_coefficient into the species table. */

/* Given: speed across the axis [m/s], diameter [m], kinematic viscosity [m2/s]. Returned: Cd [-] and
 * *derivative = dCd/dspeed [s/m]. Positive, with a continuous derivative; for 1 <= Re <= 1e7, constant below
 * 0.1 and above 5e5. Method: monotone cubic pieces in log10 Re (load/smooth.h). */
double wf_cylinder_drag(double speed, double diameter, double viscosity, double *derivative);
#endif
