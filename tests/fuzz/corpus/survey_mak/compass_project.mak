/ A project with one fixed station.
@452000.0,5123000.0,800.0,33,0.0;
&WGS 1984;
$33;
*0.00;
#compass_plain.dat,A1[m,452000,
  5123000,800],A4;
#compass_more.dat,A4;
